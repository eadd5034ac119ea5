#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "app/report/entry_list.h"
#include "app/report/report_page.h"
#include "tests/compare/made_pictures.h"
#include "tests/report/browser.h"
#include "tests/report/made_entries.h"

namespace knuckle::test {

/// A report of six images, on a desktop or, with true, on a phone: in this order another size, two places that differ,
/// one with a name that would be a script, a missing, a new and an equal one.
class ReportInBrowser : public testing::TestWithParam<bool> {
protected:
    void SetUp() override
    {
        if (Browser::program().empty())
            GTEST_SKIP() << "no chromium here, which shows the page; scripts/install.sh --browser";
        EntryList list(100'000'000);
        Picture places = madeSceneWithBox(40, 20, 30, 30);
        fillBox(places, 140, 70, 6, 4, {0, 0, 0});
        list.add(madeEntry("sub/places.png", madeScene(), places));
        list.add(madeEntry("size.png", madeScene(), flatPicture(80, 60, {90, 20, 160})));
        list.add(madeEntry("little" + oddNames()[0], madeScene(), madeSceneWithBox(3, 3, 6, 6)));
        list.add(madeSingle("gone" + oddNames()[1], madeScene(), ReportEntry::Status::Missing));
        list.add(madeSingle("more.png", places, ReportEntry::Status::New));
        list.add(madeEntry("same.png", places, places));
        writeReport(report_.path("report.html"), {"golden and out", {{"reference", "golden"}, {"output", "out"}}},
                    list.take());
        phone_ = GetParam();
        std::unique_ptr<Browser>& browser = phone_ ? phoneBrowser : desktopBrowser;
        if (!browser)
            browser = phone_ ? std::make_unique<Browser>(390, 844, true) : std::make_unique<Browser>(1280, 800, false);
        browser_ = browser.get();
        browser_->emulate("prefers-color-scheme", "light");
    }
    static void TearDownTestSuite()
    {
        phoneBrowser.reset();
        desktopBrowser.reset();
    }
    /// Opens an image and waits for its pictures.
    void open(const std::string& hash = "#image-2.slider")
    {
        browser_->open(report_.path("report.html"), hash);
        ASSERT_TRUE(browser_->waitFor("document.querySelector('#name').textContent !== ''"));
        settle();
    }
    void settle() { browser_->evaluate("new Promise(done => setTimeout(done, 150))"); }
    Json value(const std::string& expression) { return browser_->evaluate(expression); }
    std::string text(const std::string& selector)
    {
        return value("document.querySelector('" + selector + "').textContent");
    }
    bool isShown(const std::string& selector)
    {
        return value("document.querySelector('" + selector + "').checkVisibility()");
    }
    double number(const std::string& expression) { return value(expression); }
    double zoom() { return number("Number(stage.style.getPropertyValue('--s'))"); }
    void shoot(const std::string& name) { browser_->screenshot((phone_ ? "phone_" : "desktop_") + name); }
    /// Where a pixel of the picture is on the screen: its middle.
    std::pair<double, double> placeOf(int x, int y)
    {
        const Json place = value(
            "(() => { const r = document.querySelector('.half:not([hidden]) img').getBoundingClientRect(), s = "
            "Number(stage.style.getPropertyValue('--s')); return [r.x + " +
            std::to_string(x) + ".5 * s, r.y + " + std::to_string(y) + ".5 * s]; })()");
        return {place.at(0), place.at(1)};
    }

    // A browser takes a second to start.
    static inline std::unique_ptr<Browser> phoneBrowser, desktopBrowser;
    TempFolder report_;
    Browser* browser_ = nullptr;
    bool phone_ = false;
};

}  // namespace knuckle::test
