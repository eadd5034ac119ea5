#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "app/doctor/bounded.h"
#include "app/doctor/driver_findings.h"
#include "app/json/json.h"
#include "sim/base/errors.h"
#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

using test::RunResult;
using Doctor = test::CliTest;

/// The lines that contain the text.
std::string linesWith(const std::string& text, const std::string& word)
{
    std::string found;
    for (size_t at = 0; at < text.size();) {
        const size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        if (line.find(word) != std::string::npos) found += line + "\n";
        at = end + 1;
    }
    return found;
}

/// A machine that differs from this one by a folder with a program of that name.
std::string programThat(const test::TempFolder& folder, const std::string& does)
{
    std::filesystem::create_directories(folder.path("bin"));
    const std::string program = folder.write("bin/ffmpeg", "#!/bin/sh\n" + does + "\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    return "PATH=" + folder.path("bin") + ":/bin:/usr/bin";
}

TEST_F(Doctor, FindsNothingWrongWhereFilmsAreMade)
{
    const RunResult result = run({"doctor"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(linesWith(result.out, "WRONG"), "");
    for (const char* line : {"ok     library libEGL.so.1", "ok     --device software takes device",
                             "ok     driver threads: ", "ok     memory: ", "ok     open files: ", "encodes H.264"})
        EXPECT_NE(linesWith(result.out, line), "") << line << "\n" << result.out;
    EXPECT_NE(linesWith(result.out, "can simulate and draw here."), "") << result.out;
    EXPECT_EQ(run({"doctor", "--quiet"}).out, "");
    EXPECT_TRUE(madeFiles().empty());
}

TEST_F(Doctor, TellsThatNoDriverIsThere)
{
    const RunResult result = run({"doctor"}, {.environment = {"__EGL_VENDOR_LIBRARY_DIRS=/nonexistent"}});
    EXPECT_EQ(result.code, 3) << result.out;
    EXPECT_NE(linesWith(result.out, "WRONG  EGL drivers: no file in /nonexistent names one; install"), "")
        << result.out;
    EXPECT_NE(linesWith(result.out, "WRONG  --device software: "), "") << result.out;
    EXPECT_NE(linesWith(result.out, "Nothing can be simulated"), "");
    const std::string file = folder.write("vendor.json", R"({ "ICD": { "library_path": "libEGL_none.so.0" } })");
    const RunResult library = run({"doctor"}, {.environment = {"__EGL_VENDOR_LIBRARY_FILENAMES=" + file}});
    EXPECT_EQ(library.code, 3);
    EXPECT_NE(linesWith(library.out, "WRONG  EGL driver of " + file + ": libEGL_none.so.0"), "") << library.out;
}

TEST_F(Doctor, TellsThatNoLibraryIsThereAndSoDoesWhatWouldUseIt)
{
    // Files that are no libraries, where the loader looks first.
    const auto hide = [&](const std::string& name) {
        std::filesystem::create_directories(folder.path(name));
        return folder.write(name + "/" + name, "");
    };
    for (const std::string name : {"libEGL.so.1", "libOpenGL.so.0"}) {
        std::string folders = std::filesystem::path(hide(name)).parent_path();
        if (name == "libOpenGL.so.0") folders += ":" + std::filesystem::path(hide("libGL.so.1")).parent_path().string();
        const std::vector<std::string> environment{"LD_LIBRARY_PATH=" + folders};
        const RunResult told = run({"doctor"}, {.environment = environment});
        EXPECT_EQ(told.code, 3) << told.err;
        EXPECT_NE(linesWith(told.out, "WRONG  library " + name + ": "), "") << told.out;
        EXPECT_NE(linesWith(told.out, "WRONG  --device software: library " + name), "") << told.out;
        EXPECT_EQ(linesWith(told.out, "crashed"), "");
        // One remedy, not two.
        const std::string devices = linesWith(told.out, "WRONG  devices: ");
        EXPECT_EQ(devices.find("; install"), devices.rfind("; install")) << devices;
        const RunResult film = run({"render", scene, "-o", folder.path("frames")}, {.environment = environment});
        EXPECT_EQ(film.code, 3);
        EXPECT_TRUE(test::isOneLine(film.err)) << film.err;
        EXPECT_NE(film.err.find("library " + name), std::string::npos) << film.err;
        EXPECT_NE(film.err.find("install lib"), std::string::npos) << film.err;
        EXPECT_NE(film.err.find("`knuckle doctor` says more"), std::string::npos) << film.err;
    }
}

TEST_F(Doctor, PrintsJson)
{
    const RunResult lines = run({"doctor"});
    const RunResult result = run({"doctor", "--json", "--quiet"});
    EXPECT_EQ(result.code, 0) << result.err;
    const Json json = parseJson(result.out, "output");
    EXPECT_EQ("knuckle " + json.at("version").get<std::string>() + "\n", run({"--version"}).out);
    EXPECT_EQ(json.at("device"), "software");
    EXPECT_EQ(json.at("usable"), true);
    EXPECT_EQ(json.at("software"), true);
    // Each is a line of the other form; times and memory differ from run to run.
    std::string heads, lineHeads;
    for (const Json& finding : json.at("findings")) {
        const std::string what = finding.at("what");
        heads += fmt::format("{:<7}{}\n", finding.at("health").get<std::string>(),
                             what.substr(0, what.find_first_of(":;")));
        EXPECT_TRUE(finding.at("remedy").is_null() || finding.at("remedy").is_string());
    }
    std::istringstream read(lines.out);
    for (std::string line; std::getline(read, line) && !line.empty();)
        lineHeads += line.substr(0, line.find_first_of(":;")) + "\n";
    EXPECT_EQ(heads, lineHeads);

    // Bytes in it that are no UTF-8.
    const RunResult none = run({"doctor", "--json"}, {.environment = {"__EGL_VENDOR_LIBRARY_DIRS=/none\xff"}});
    EXPECT_EQ(none.code, 3);
    const Json broken = parseJson(none.out, "output");
    EXPECT_EQ(broken.at("usable"), false);
    EXPECT_TRUE(broken.at("software").is_null());
    const auto wrong = std::ranges::find_if(broken.at("findings"), [](const Json& finding) {
        return finding.at("what").get<std::string>().starts_with("EGL drivers: no file in /none");
    });
    ASSERT_NE(wrong, broken.at("findings").end()) << none.out;
    EXPECT_EQ(wrong->at("health"), "wrong");
    EXPECT_TRUE(wrong->at("remedy").get<std::string>().starts_with("install")) << wrong->dump();
}

TEST_F(Doctor, RefusesTheNumberOfNoDevice)
{
    const std::string said = test::runKnuckle({"info", "--device", "99"}).err;
    for (const bool json : {false, true}) {
        std::vector<std::string> words{"doctor", "--device", "99"};
        if (json) words.push_back("--json");
        const RunResult result = test::runKnuckle(words);
        EXPECT_EQ(result.code, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err, said);
        EXPECT_TRUE(result.err.starts_with("knuckle: --device 99: there are only ")) << result.err;
    }
    // Without any device the number is not what is wrong.
    const std::string environment = "__EGL_VENDOR_LIBRARY_DIRS=/nonexistent";
    const RunResult none = test::runKnuckle({"doctor", "--device", "99"}, {.environment = {environment}});
    EXPECT_EQ(none.code, 3) << none.err;
    EXPECT_NE(linesWith(none.out, "WRONG  --device 99: "), "") << none.out;
    EXPECT_EQ(none.out.find("--device 99: --device"), std::string::npos) << none.out;
}

TEST_F(Doctor, TellsWhatFilmsLack)
{
    const RunResult none = run({"doctor"}, {.environment = {"PATH=/nonexistent"}});
    EXPECT_EQ(none.code, 0);
    EXPECT_EQ(linesWith(none.out, "WRONG"),
              "WRONG  ffmpeg is not in PATH: frames can be made, films cannot; install it "
              "(apt install ffmpeg)\n");
    // One that has no VP9.
    const std::string path = programThat(folder, "case \"$*\" in *libvpx-vp9*) exit 1;; esac");
    const RunResult some = run({"doctor"}, {.environment = {path}});
    EXPECT_EQ(some.code, 0);
    EXPECT_EQ(linesWith(some.out, "WRONG"), "WRONG  ffmpeg cannot encode VP9: no .webm; install an ffmpeg that has it, "
                                            "or end films in something else\n");
    const std::string lame = programThat(folder, "echo libmissing.so.1: cannot open shared object file >&2; exit 127");
    const RunResult broken = run({"doctor"}, {.environment = {lame}});
    EXPECT_EQ(linesWith(broken.out, "WRONG"), linesWith(broken.out, "WRONG  ffmpeg does not start")) << broken.out;
    EXPECT_NE(linesWith(broken.out, "libmissing.so.1"), "") << broken.out;
    EXPECT_NE(linesWith(some.out, "bin/ffmpeg encodes H.264, H.265, AV1, GIF, WebP, APNG"), "") << some.out;
}

TEST_F(Doctor, TellsLimitsThatAreTooLow)
{
    const auto few = [] {
        const rlimit files{64, 64};
        setrlimit(RLIMIT_NOFILE, &files);
    };
    const std::string environment = "MESA_SHADER_CACHE_DIR=/dev/null/none";
    const RunResult result = run({"doctor"}, {.environment = {environment, "DISPLAY=:77"}, .inChild = few});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(linesWith(result.out, "WRONG"), "WRONG  open files: 64 allowed; raise it (ulimit -n 1024)\n");
    EXPECT_NE(linesWith(result.out, "note   shader cache: /dev/null/none cannot be written; set"), "") << result.out;
    EXPECT_NE(linesWith(result.out, "note   DISPLAY=:77 points nowhere"), "") << result.out;
    for (const std::string display : {"localhost:77.0", "unix:77", "screen"}) {
        const RunResult nowhere = run({"doctor"}, {.environment = {"DISPLAY=" + display}});
        EXPECT_EQ(nowhere.code, 0);
        EXPECT_NE(linesWith(nowhere.out, "note   DISPLAY=" + display + " points nowhere"), "") << nowhere.out;
    }
    // The superuser has no limit of processes.
    const auto alone = [] {
        const rlimit processes{100, 100};
        if (setrlimit(RLIMIT_NPROC, &processes) != 0 || (geteuid() == 0 && setuid(64321) != 0)) _exit(99);
    };
    const RunResult crowded = run({"doctor"}, {.folder = "/", .inChild = alone});
    EXPECT_NE(linesWith(crowded.out, "WRONG  processes and threads: 100 allowed; allow more (ulimit -u;"), "")
        << crowded.out << crowded.err;
    const auto little = [] {
        const rlimit space{rlim_t{150} << 20, rlim_t{150} << 20};
        setrlimit(RLIMIT_AS, &space);
    };
    const RunResult starved = run({"doctor"}, {.inChild = little});
    EXPECT_EQ(starved.code, 3) << starved.out << starved.err;
    EXPECT_NE(linesWith(starved.out, "WRONG  address space is limited to 150 MiB; raise it"), "") << starved.out;
}

TEST_F(Doctor, KnowsGpusThatCannotBeUsed)
{
    EXPECT_TRUE(findNvidia(folder.path()).empty());
    std::filesystem::create_directories(folder.path("dev/dri"));
    folder.write("dev/nvidiactl", "");
    const Findings without = findNvidia(folder.path());
    ASSERT_EQ(without.size(), 1u);
    EXPECT_EQ(without[0].health, Health::Wrong);
    EXPECT_NE(without[0].remedy.find("NVIDIA_DRIVER_CAPABILITIES=all"), std::string::npos);
    std::filesystem::create_directories(folder.path("usr/share/glvnd/egl_vendor.d"));
    folder.write("usr/share/glvnd/egl_vendor.d/10_nvidia.json",
                 R"({ "ICD": { "library_path": "libEGL_nvidia.so.0" } })");
    EXPECT_EQ(findNvidia(folder.path()).at(0).health, Health::Ok);

    EXPECT_EQ(findGpuFiles(folder.path()).at(0).health, Health::Note);
    folder.write("dev/dri/renderD128", "");
    EXPECT_EQ(findGpuFiles(folder.path()).at(0).health, Health::Ok);
    // Opened, not only looked at: a file that is there, and that nothing answers for.
    std::filesystem::remove(folder.path("dev/dri/renderD128"));
    std::filesystem::create_directory(folder.path("dev/dri/renderD128"));
    const Findings deaf = findGpuFiles(folder.path());
    EXPECT_EQ(deaf.at(0).health, Health::Note);
    EXPECT_NE(deaf.at(0).what.find("renderD128 is no GPU"), std::string::npos) << deaf.at(0).what;
    std::filesystem::remove(folder.path("dev/dri/renderD128"));
    folder.write("dev/dri/renderD128", "");
    if (geteuid() == 0) return;  // may use all files
    std::filesystem::permissions(folder.path("dev/dri/renderD128"), std::filesystem::perms::none);
    EXPECT_EQ(findGpuFiles(folder.path()).at(0).health, Health::Wrong);
}

TEST(Bounded, OutlivesWhatCrashesAndHangs)
{
    EXPECT_EQ(runBounded([] { return std::string("fine"); }, 5).text, "fine");
    EXPECT_EQ(runBounded([]() -> std::string { throw InputError("no such thing"); }, 5).failure, "no such thing");
    EXPECT_NE(runBounded([]() -> std::string { std::abort(); }, 5).failure.find("crashed"), std::string::npos);
    const std::string late = runBounded(
                                 []() -> std::string {
                                     for (;;) pause();
                                 },
                                 1)
                                 .failure;
    EXPECT_TRUE(late.starts_with("took more than")) << late;
}

}  // namespace
}  // namespace knuckle
