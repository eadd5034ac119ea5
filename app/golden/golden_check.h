#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/compare/report_outputs.h"
#include "app/golden/golden_driver.h"
#include "app/golden/golden_file.h"
#include "app/golden/state_difference.h"
#include "app/run/interrupt.h"
#include "app/run/open_gpu.h"

namespace knuckle {

/// What of goldens is checked.
struct CheckOptions {
    bool states = true, pictures = true;
    std::optional<uint64_t> until;  ///< Later frames are left out.
    std::vector<Override> changes;  ///< Of all scenes, to try what a check sees.
    ReportOptions reports;
};

/// A state or a picture that was compared.
struct GoldenItem {
    enum class Kind : uint8_t { Physics, Drawing, Image } kind = Kind::Drawing;

    std::string golden = {};
    std::string stem = {};                      ///< "frame_0012", "logo".
    uint64_t frame = 0;                         ///< Of a scene.
    std::optional<StateDifference> state = {};  ///< Of Kind::Physics.
    ReportEntry entry = {};                     ///< Its `allowed`: it is advisory.
};

/// A golden that was checked.
struct CheckedGolden {
    ChosenReference reference;
    std::vector<GoldenItem> items;

    bool failed() const;
};

/// Compares a golden with its references. What is wrong with it becomes an item that cannot be read.
/// @param gpu of this thread; null for pictures of other programs. @throws RunError, Interrupted.
CheckedGolden checkGolden(const Golden& golden, const CheckOptions& options, Gpu* gpu, const InterruptGuard& interrupt);

/// A device for goldens; null if all are pictures of other programs. @throws DeviceError.
std::unique_ptr<Gpu> openFor(const std::vector<Golden>& goldens, const CommonOptions& common);

/// Calls `act` for each golden, on as many threads as the machine has cores, each with a context of its own.
/// @param gpu null: so are the contexts. @param act of the golden's index; what it computes must go to a place of its
/// own.
void forEachGolden(size_t count, const Gpu* gpu, const std::function<void(size_t, Gpu*)>& act);

/// Notes in an entry that is not equal by which command it is accepted.
void noteRemedy(const Golden& golden, ReportEntry& entry);

/// A word for the kind of an item: "physics", "drawing", "image".
const char* kindWord(GoldenItem::Kind kind);

}  // namespace knuckle
