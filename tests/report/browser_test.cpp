// The page in headless Chromium; skipped where there is none. scripts/report_test.sh keeps screenshots.
#include <cmath>

#include "tests/report/browser_fixture.h"

namespace knuckle {
namespace {

using test::Json;
using test::ReportInBrowser;

TEST_P(ReportInBrowser, ShowsTheWorstFirst)
{
    open("");
    EXPECT_EQ(text("#name"), "size.png");
    EXPECT_EQ(text(".summary"), "3 of 4 images differ, 1 missing, 1 new");
    EXPECT_EQ(text("#position"), "1 / 6");
    EXPECT_EQ(value("[...document.querySelectorAll('#list bdi')].map(e => e.textContent)"),
              Json({"size.png", "sub/places.png", "little" + test::oddNames()[0], "gone" + test::oddNames()[1],
                    "more.png", "same.png"}));
    EXPECT_EQ(value("window.broken === undefined"), true) << "names are harmless";
    EXPECT_FALSE(isShown("#images"));
    EXPECT_LE(number("document.documentElement.scrollWidth"), number("innerWidth")) << "nothing is cut off";
    EXPECT_TRUE(value("document.querySelector('#modes [value=heatmap]').disabled")) << "of other sizes there is none";
    const bool oneColumn = value("document.querySelector('#view').getBoundingClientRect().left < 5");
    EXPECT_EQ(oneColumn, phone_);
    shoot("size");
}

TEST_P(ReportInBrowser, MovesTheDivider)
{
    open();
    const auto share = [&] { return number("Number(document.querySelector('#divider').ariaValueNow)"); };
    const auto clip = [&] { return value("document.querySelectorAll('.half')[1].style.clipPath"); };
    EXPECT_EQ(share(), 50);
    EXPECT_EQ(clip(), "inset(0px 0px 0px 50%)");
    shoot("slider");
    const Json area = value(
        "(() => { const r = stage.getBoundingClientRect(); return [r.x, r.y, r.width, r.height]; })()");
    const double left = area.at(0), top = area.at(1), width = area.at(2), height = area.at(3);
    browser_->drag(left + width / 2, top + height / 2, left + width * 0.3, top + height / 2);
    EXPECT_NEAR(share(), 30, 1);
    shoot("slider_moved");
    // Anywhere on the picture, as long as all of it is seen.
    browser_->drag(left + width * 0.8, top + height * 0.4, left + width * 0.7, top + height * 0.4);
    EXPECT_NEAR(share(), 70, 1);
    value("document.querySelector('#divider').focus()");
    browser_->press("ArrowLeft");
    EXPECT_NEAR(share(), 68, 1);
    EXPECT_EQ(text("#name"), "sub/places.png") << "the key moved the divider alone";
}

TEST_P(ReportInBrowser, Blinks)
{
    open();
    browser_->click("#modes [value=blink]");
    EXPECT_TRUE(isShown("#blink-run"));
    const char* other = "!document.querySelectorAll('.half')[1].hidden";
    EXPECT_EQ(value(other), false);
    shoot("blink_reference");
    EXPECT_TRUE(browser_->waitFor(other));
    EXPECT_TRUE(browser_->waitFor("document.querySelectorAll('.half')[1].hidden"));
    browser_->press("b");
    const bool before = value(other);
    value("new Promise(done => setTimeout(done, 900))");
    EXPECT_EQ(value(other), before) << "it stands still";
    browser_->click("#blink-other");
    EXPECT_EQ(value(other), !before);
    if (before) browser_->press(" ");
    EXPECT_EQ(value(other), true);
    EXPECT_EQ(text(".pane .badge.right"), "output");
    shoot("blink_output");
    browser_->press(" ");
    EXPECT_EQ(value(other), false);
    browser_->emulate("prefers-reduced-motion", "reduce");
    open("#image-2.blink");
    EXPECT_EQ(value("document.querySelector('#blink-run').ariaPressed"), "false") << "who wants no motion gets none";
}

TEST_P(ReportInBrowser, ShowsBothAndMaps)
{
    open();
    browser_->press("3");
    settle();
    const Json panes = value("[...document.querySelectorAll('.pane')].map(e => e.getBoundingClientRect().toJSON())");
    EXPECT_EQ(panes.at(0).at("x") == panes.at(1).at("x"), phone_) << "side by side, on a phone below each other";
    EXPECT_EQ(panes.at(0).at("y") == panes.at(1).at("y"), !phone_);
    EXPECT_EQ(panes.at(0).at("width"), panes.at(1).at("width"));
    shoot("two");
    browser_->click("#modes [value=heatmap]");
    settle();
    EXPECT_TRUE(isShown("#legend .bar"));
    EXPECT_EQ(text("#legend .marks"), "00.250.50.751");
    EXPECT_EQ(value("getComputedStyle(document.querySelector('#legend .bar')).backgroundImage.startsWith("
                    "'linear-gradient(to right, rgb(0, 0, 4)')"),
              true);
    shoot("heatmap");
    browser_->press("5");
    EXPECT_TRUE(isShown("#legend"));
    EXPECT_FALSE(isShown("#legend .bar"));
    EXPECT_EQ(text(".badge"), "difference × 8");
    shoot("difference");
    EXPECT_EQ(value("location.hash"), "#image-2.difference");
}

TEST_P(ReportInBrowser, ZoomsAndReadsPixels)
{
    open();
    const double fit = zoom();
    EXPECT_GE(fit, 2) << "a small picture is shown with whole pixels";
    EXPECT_EQ(fit, std::floor(fit));
    EXPECT_TRUE(value("stage.classList.contains('pixels')"));
    browser_->press("+");
    EXPECT_NEAR(zoom(), fit * 1.5, 1e-6);
    browser_->click("#zoom-out");
    EXPECT_NEAR(zoom(), fit, 1e-6);
    const auto [x, y] = placeOf(50, 30);
    if (phone_) browser_->pinch(x, y, 40, 160);
    else browser_->wheel(x, y, -400);
    settle();
    EXPECT_GT(zoom(), fit * 1.9);
    const auto [atX, atY] = placeOf(50, 30);
    EXPECT_NEAR(atX, x, phone_ ? 40 : 3) << "what is below the pointer stays there";
    if (phone_) browser_->drag(atX, atY, atX, atY);
    else browser_->moveTo(atX, atY);
    // x, 2 y and x + y of the scene; the output is white there.
    EXPECT_EQ(text("#values"), "50,30\nreference  50 60 16\noutput     255 255 255\ndifference   +205 +195 +239");
    shoot("zoomed");
    const double shift = number("Number(stage.style.getPropertyValue('--x'))");
    browser_->drag(atX, atY, atX + 50, atY + 5);
    EXPECT_NE(number("Number(stage.style.getPropertyValue('--x'))"), shift) << "a larger picture is moved";
    EXPECT_EQ(number("Number(document.querySelector('#divider').ariaValueNow)"), 50) << "two fingers do not move it";
    browser_->press("0");
    EXPECT_NEAR(zoom(), fit, 1e-6);
}

TEST_P(ReportInBrowser, MarksPlaces)
{
    open();
    EXPECT_EQ(value("document.querySelectorAll('.pane .box').length"), 4) << "two in each of two panes";
    const auto [x, y] = placeOf(40, 20);
    const Json box = value("document.querySelector('.box').getBoundingClientRect().toJSON()");
    const double s = zoom(), frame = 4;
    EXPECT_NEAR(box.at("x").get<double>(), x - s / 2 - frame, 0.6);
    EXPECT_NEAR(box.at("y").get<double>(), y - s / 2 - frame, 0.6);
    EXPECT_NEAR(box.at("width").get<double>(), 30 * s + 2 * frame, 0.6);
    browser_->click("#boxes");
    EXPECT_EQ(value("document.querySelectorAll('.pane .box').length"), 0);
    shoot("no_places");
    browser_->press("p");
    EXPECT_EQ(value("document.querySelectorAll('.pane .box').length"), 4);
    browser_->click("#next-place");
    browser_->press("n");
    settle();
    EXPECT_GT(zoom(), s * 3) << "the second place is small";
    shoot("next_place");
    browser_->click("#details .places li:first-child button");
    EXPECT_LT(zoom(), s * 3);
}

TEST_P(ReportInBrowser, Filters)
{
    open("");
    const auto shown = [&] { return value("document.querySelectorAll('#list li').length"); };
    EXPECT_EQ(value("[...document.querySelectorAll('#filters button')].map(e => e.textContent)"),
              Json({"all 6", "failed 5", "different 3", "missing 1", "new 1", "equal 1"}));
    browser_->click("#filters [value=missing]");
    EXPECT_EQ(shown(), 1);
    EXPECT_TRUE(text("#name").starts_with("gone\"><img"));
    EXPECT_EQ(text("#position"), "1 / 1");
    EXPECT_FALSE(isShown("#modes")) << "there is one picture";
    settle();
    shoot("missing");
    browser_->press("f");
    EXPECT_EQ(text("#name"), "more.png");
    browser_->press("f");
    EXPECT_EQ(text("#name"), "same.png");
    EXPECT_FALSE(isShown("#stage"));
    EXPECT_FALSE(isShown("#tools"));
    EXPECT_EQ(text("#empty"), "no pictures: equal");
    shoot("equal");
    browser_->press("f");
    EXPECT_EQ(shown(), 6);
    browser_->click("#filters [value=failed]");
    EXPECT_EQ(shown(), 5);
}

TEST_P(ReportInBrowser, FollowsKeys)
{
    open("");
    for (const char* key : {"j", "ArrowDown", "ArrowRight"}) browser_->press(key);
    EXPECT_EQ(text("#position"), "4 / 6");
    for (const char* key : {"k", "ArrowUp"}) browser_->press(key);
    EXPECT_EQ(text("#name"), "sub/places.png");
    browser_->click("#previous");
    browser_->press("k");
    EXPECT_EQ(text("#position"), "1 / 6") << "there is nothing before the first";
    browser_->press("j");
    const char* modes[] = {"slider", "blink", "two", "heatmap", "difference"};
    for (int i = 0; i < 5; ++i) {
        browser_->press(std::to_string(i + 1));
        EXPECT_EQ(value("document.querySelector('#stage').dataset.mode"), modes[i]);
    }
    browser_->press("?");
    EXPECT_TRUE(isShown("#help"));
    shoot("help");
    browser_->press("j");
    EXPECT_EQ(text("#name"), "sub/places.png") << "while help is open";
    browser_->click("#help button");
    EXPECT_FALSE(isShown("#help"));
    browser_->click("#list li:nth-child(3) button");
    EXPECT_EQ(text("#position"), "3 / 6");
    EXPECT_GE(number("document.querySelector('#view').getBoundingClientRect().top"), -1) << "the image is seen";
    settle();
    shoot("chosen");
}

TEST_P(ReportInBrowser, IsATableWithoutScripts)
{
    browser_->setScripts(false);
    browser_->open(report_.path("report.html"));
    browser_->setScripts(true);
    EXPECT_FALSE(isShown("#viewer"));
    EXPECT_EQ(value("document.querySelectorAll('#images tbody tr').length"), 6);
    EXPECT_EQ(value("document.querySelectorAll('#images img').length"), 2 + 4 + 4 + 1 + 1);
    EXPECT_EQ(value("[...document.querySelectorAll('#images td.picture img')].every(e => e.checkVisibility())"), true);
    EXPECT_TRUE(isShown("#images .figures"));
    EXPECT_LE(number("document.documentElement.scrollWidth"), number("innerWidth"));
    shoot("table");
}

TEST_P(ReportInBrowser, IsDarkWhereThatIsPreferred)
{
    const char* back = "getComputedStyle(document.body).backgroundColor";
    open();
    EXPECT_EQ(value(back), "rgb(255, 255, 255)");
    browser_->emulate("prefers-color-scheme", "dark");
    EXPECT_EQ(value(back), "rgb(21, 23, 27)");
    shoot("dark");
}

INSTANTIATE_TEST_SUITE_P(On, ReportInBrowser, testing::Bool(),
                         [](const testing::TestParamInfo<bool>& on) { return on.param ? "Phone" : "Desktop"; });

}  // namespace
}  // namespace knuckle
