#pragma once

#include "tests/solver/contact/contact_fixture.h"

namespace knuckle::test {

/// Assemblies (gpu::uvec2: calm steps, name of their island) that move, are calm or sleep, at random, and 1501 contacts
/// between them.
class SleepFixture : public ContactFixture {
public:
    /// @param freezes each assembly by itself, instead of islands that sleep.
    explicit SleepFixture(bool freezes = false);

    uint32_t calmSteps() const { return stages.parameters.calmSteps; }
    uint32_t assemblyCount() const { return stages.parameters.assemblyCount; }
    uint32_t assemblyOf(uint32_t mover) const { return infos_[mover].assembly; }
    bool isAsleep(uint32_t assembly) const { return calms[assembly].x >= calmSteps(); }
    /// Runs sim/sleep/<name> over so many threads.
    void runSleep(const std::string& name, uint64_t threads, const Defines& more = {});
    void forAssemblies(const std::string& name, const Defines& more = {}) { runSleep(name, assemblyCount(), more); }
    void setCalms(const std::vector<gpu::uvec2>& values);
    void setNext(const std::vector<gpu::uvec2>& values);
    /// Counts as at the start of a frame, or any that an update may find.
    std::vector<gpu::uvec2> randomCalms(uint32_t seed) const;
    std::vector<gpu::uvec2> nextCalms() const { return stages.sleep->assemblyNext.download(); }
    void expectCalms(const std::vector<gpu::uvec2>& found, const std::vector<gpu::uvec2>& wanted) const;

    std::vector<gpu::uvec2> calms, next;

private:
    void makePairs();

    std::vector<gpu::Mover> infos_;
};

}  // namespace knuckle::test
