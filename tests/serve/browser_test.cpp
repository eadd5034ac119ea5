#include <gtest/gtest.h>

#include "tests/cli/run_program.h"
#include "tests/places.h"
#include "tests/report/browser.h"
#include "tests/serve/served.h"

namespace knuckle::test {

namespace {

/// A figure that lies, a ball beside it, and a lamp that hangs until somebody lets go.
std::string sceneText()
{
    return R"({ "duration": 4, "diameter": 0.06,
  "colliders": [{ "type": "plane", "floor": "checker" }],
  "objects": [
    { "type": "actor", "name": "figure", "file": ")" +
           inSource("assets/models/humanoid.glb") + R"(", "position": [0, 0.3, 0], "rotation": [-90, 0, 0] },
    { "type": "rigid", "shape": "sphere", "name": "ball", "radius": 0.2, "position": [1.1, 0.2, 0] },
    { "type": "rigid", "shape": "box", "name": "lamp", "size": [0.3, 0.3, 0.3], "position": [-0.9, 1.4, 0],
      "fixed": true, "release": { "time": 1000 } }],
  "camera": { "position": [0, 1.6, 4.2], "target": [0, 0.55, 0], "fieldOfView": 40 } })";
}

/// Names what is at places of a row until one of them matches. @returns its place in the window, or null.
const char* const FIND = R"(
window.find = async (pattern, y) => {
  const box = document.querySelector('#picture').getBoundingClientRect();
  for (let x = 0.1; x < 0.9; x += 0.025) {
    const answer = await fetch('input', { method: 'POST', body: JSON.stringify({ do: 'pick', at: [x, y] }) });
    if (answer.status === 429) { await new Promise(done => setTimeout(done, 300)); continue; }
    const found = await answer.json();
    if (new RegExp(pattern).test(found.name)) return [box.x + x * box.width, box.y + y * box.height, found.name];
  }
  return null;
};
window.seen = () => {
  const image = document.querySelector('#picture'), canvas = document.createElement('canvas');
  canvas.width = 320; canvas.height = 180;
  const context = canvas.getContext('2d');
  context.drawImage(image, 0, 0, 320, 180);
  return context.getImageData(0, 0, 320, 180).data;
};
window.keep = () => { window.kept = window.seen(); return true; };
window.changed = () => {
  const now = window.seen();
  let count = 0;
  for (let i = 0; i < now.length; i += 4) count += Math.abs(now[i] - window.kept[i]) > 24;
  return count;
};
true)";

class ServeInBrowser : public testing::Test {
protected:
    void SetUp() override
    {
        if (Browser::program().empty())
            GTEST_SKIP() << "no chromium here, which shows the page; scripts/install.sh --browser";
        served_ = std::make_unique<Served>(
            scene_, std::vector<std::string>{"--log", log_, "--hash", "--size", "640x360", "--ball", "0.15"});
        browser_ = std::make_unique<Browser>(1280, 720, false);
        browser_->openAddress(served_->address());
        browser_->evaluate(FIND);
        ASSERT_TRUE(browser_->waitFor("document.querySelector('#picture').naturalWidth === 640")) << "no picture";
        ASSERT_TRUE(browser_->waitFor("Number(document.querySelector('#step').textContent) > 5")) << "no figures";
    }
    std::string text(const std::string& selector)
    {
        return browser_->evaluate("document.querySelector('" + selector + "').textContent");
    }
    double step() { return std::stod(text("#step")); }
    /// Where something with a name that matches is seen.
    std::pair<double, double> find(const std::string& pattern)
    {
        // A row at a time, which a busy machine has in the time that the browser gets for an answer.
        for (double y = 0.2; y < 0.95; y += 0.035) {
            const Json place = browser_->evaluate("find('" + pattern + "', " + std::to_string(y) + ")");
            if (place.is_array()) return {place.at(0), place.at(1)};
        }
        ADD_FAILURE() << "nothing like " << pattern << " is seen";
        return {640, 360};
    }
    void setPaused(bool paused)
    {
        if ((text("#run") == "run") != paused) browser_->click("#run");
        EXPECT_TRUE(browser_->waitFor("document.querySelector('#run').textContent === '" +
                                      std::string(paused ? "run" : "pause") + "'"));
    }
    void rest(int milliseconds)
    {
        browser_->evaluate("new Promise(done => setTimeout(done, " + std::to_string(milliseconds) + "))");
    }
    size_t logged(const std::string& words) const
    {
        const std::string log = readText(log_);
        size_t count = 0;
        for (size_t at = log.find(words); at != std::string::npos; at = log.find(words, at + 1)) ++count;
        return count;
    }

    void pullAnArm()
    {
        const auto [x, y] = find("figure/.*(arm|hand)");
        browser_->evaluate("keep()");
        setPaused(false);
        browser_->mouseDown(x, y, Browser::CONTROL);
        for (int k = 1; k <= 12; ++k) {
            browser_->mouseMove(x, y - 20.0 * k, Browser::CONTROL);
            rest(100);
        }
        browser_->screenshot("serve_2_pulled");
        EXPECT_TRUE(browser_->waitFor("changed() > 300")) << "pulling moves nothing";
        EXPECT_GT(logged(R"("push":"figure/)"), 10u) << "pulls are not logged";
        browser_->mouseUp(x, y - 240.0, Browser::CONTROL);
        rest(800);
    }
    void throwTheBall()
    {
        const auto [x, y] = find("^ball$");
        const size_t before = logged(R"("push":"ball")");
        browser_->doubleClick(x, y);
        EXPECT_TRUE(isChosen("ball"));
        rest(400);
        EXPECT_EQ(logged(R"("push":"ball")"), before + 1) << "a throw is not logged";
        browser_->screenshot("serve_3_thrown");
    }
    void throwAnotherBall()
    {
        browser_->evaluate("keep()");
        browser_->moveTo(640, 420);
        browser_->press("b");
        EXPECT_TRUE(browser_->waitFor("changed() > 300")) << "no ball flies";
        EXPECT_EQ(logged(R"("throw":"thrown_ball")"), 1u) << "B throws nothing";
        browser_->screenshot("serve_3_another_ball");
    }
    void releaseTheLamp()
    {
        setPaused(true);
        const auto [x, y] = find("^lamp$");
        browser_->drag(x, y, x, y);
        EXPECT_TRUE(isChosen("lamp"));
        browser_->screenshot("serve_4_chosen");
        browser_->evaluate("keep()");
        browser_->click("#release");
        setPaused(false);
        EXPECT_TRUE(browser_->waitFor("changed() > 300")) << "nothing falls";
        EXPECT_EQ(logged(R"("release":"lamp")"), 1u) << "a release is not logged";
    }
    void turnGravityOver()
    {
        const std::string slider = "document.querySelector('[data-field=\"gravity y\"]')";
        browser_->press("g");
        ASSERT_TRUE(browser_->waitFor(slider + ".checkVisibility()"));
        const Json box = browser_->evaluate(
            "(() => { const r = " + slider +
            ".getBoundingClientRect(); return [r.x, r.y + r.height / 2, r.width]; })()");
        const double left = box.at(0), height = box.at(1), width = box.at(2);
        browser_->drag(left + 0.31 * width, height, left + 0.6 * width, height);
        rest(900);
        EXPECT_GT(logged(R"("set":"gravity")"), 0u) << "the slider changes nothing";
        EXPECT_GT(browser_->evaluate("Number(" + slider + ".value)").get<double>(), 0.0);
        browser_->screenshot("serve_5_upwards");
    }
    bool isChosen(const std::string& name)
    {
        return browser_->waitFor("document.querySelector('#chosen-name').textContent === '" + name + "'");
    }
    /// Ends the program, and replays its log.
    void expectTheSameAgain()
    {
        const std::string said = served_->end();
        const RunResult replay = runKnuckle(
            {"--device", "software", "serve", scene_, "--replay", log_, "--hash", "--ball", "0.15"});
        EXPECT_EQ(replay.code, 0) << replay.err;
        const size_t at = said.find("state hash ");
        ASSERT_NE(at, std::string::npos) << said;
        EXPECT_NE(replay.out.find(said.substr(at, 27)), std::string::npos) << replay.out << said;
    }

    TempFolder folder_;
    std::string scene_ = folder_.write("live.json", sceneText()), log_ = folder_.path("live.log");
    std::unique_ptr<Served> served_;
    std::unique_ptr<Browser> browser_;
};

TEST_F(ServeInBrowser, IsPausedPulledThrownReleasedAndSetAndReplaysToTheSameBits)
{
    browser_->emulate("prefers-color-scheme", "dark");
    setPaused(true);
    const double paused = step();
    rest(500);
    EXPECT_EQ(step(), paused) << "a pause goes on";
    browser_->screenshot("serve_1_paused");
    pullAnArm();
    throwTheBall();
    throwAnotherBall();
    releaseTheLamp();
    turnGravityOver();
    expectTheSameAgain();
}

TEST_F(ServeInBrowser, BeginsAnewWithAnotherValueAndSaysWhatIsWrongWithOne)
{
    browser_->press("g");
    const auto restartWith = [&](const std::string& set) {
        browser_->evaluate("document.querySelector('#set').value = '" + set + "'");
        browser_->click("#restart button");
    };
    restartWith("solver.substep=6");
    EXPECT_TRUE(browser_->waitFor("document.querySelector('#message').textContent.includes('substep')"));
    browser_->screenshot("serve_6_refused");
    restartWith("solver.substeps=6");
    EXPECT_TRUE(browser_->waitFor("document.querySelector('#message').textContent === ''"));
    EXPECT_EQ(logged(R"("restart":["solver.substeps=6"])"), 1u);
    expectTheSameAgain();
}

TEST_F(ServeInBrowser, APageOfAnotherSiteNeitherSeesNorSteers)
{
    setPaused(true);
    const double before = step();
    Browser other(640, 360, false);
    other.open(folder_.write("other.html", "<!DOCTYPE html><title>other</title>"));
    // What a page may send without being asked first, and may not read.
    const auto sends = [&](const std::string& wish) {
        return other.evaluate("fetch('" + served_->address() + "input', { method: 'POST', mode: 'no-cors', body: '" +
                              wish + "' }).then(() => 'sent', () => 'failed')");
    };
    EXPECT_EQ(sends(R"({"do": "step", "count": 5})"), "sent");
    EXPECT_EQ(sends(R"({"do": "run"})"), "sent");
    for (const char* path : {"", "events"})
        EXPECT_EQ(other.evaluate("fetch('" + served_->address() + path + "').then(() => 'read', () => 'failed')"),
                  "failed")
            << path;
    EXPECT_EQ(other.evaluate("new Promise(done => { const image = new Image(); image.onload = () => done('seen'); "
                             "image.onerror = () => done('refused'); image.src = '" +
                             served_->address() + "stream'; })"),
              "refused");
    rest(500);
    EXPECT_EQ(step(), before) << "another site steers";
    browser_->press("s");
    EXPECT_TRUE(browser_->waitFor("Number(document.querySelector('#step').textContent) === " +
                                  std::to_string(static_cast<int>(before) + 1)))
        << "its own page does not";
}

TEST_F(ServeInBrowser, FitsALightScreenAndASmallOne)
{
    browser_->emulate("prefers-color-scheme", "light");
    browser_->press("?");
    EXPECT_TRUE(browser_->waitFor("document.querySelector('#help').open"));
    rest(300);
    browser_->screenshot("serve_7_light_help");
    browser_.reset();
    Browser phone(390, 844, true);
    phone.openAddress(served_->address());
    EXPECT_TRUE(phone.waitFor("Number(document.querySelector('#step').textContent) > 5")) << "no figures";
    EXPECT_TRUE(phone.evaluate("document.documentElement.scrollWidth <= innerWidth").get<bool>());
    phone.screenshot("serve_8_phone");
}

}  // namespace

}  // namespace knuckle::test
