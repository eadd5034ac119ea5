#include "app/doctor/findings_json.h"

#include "app/json/json.h"

namespace knuckle {

std::string findingsAsJson(const Findings& findings, const DriverFindings& driver, const std::string& device)
{
    constexpr const char* WORDS[] = {"ok", "note", "wrong"};
    Json list = Json::array();
    for (const Finding& finding : findings) {
        list.push_back({{"health", WORDS[static_cast<int>(finding.health)]}, {"what", finding.what}});
        list.back()["remedy"] = finding.remedy.empty() ? Json() : Json(finding.remedy);
    }
    const Json json = {{"version", KNUCKLE_VERSION},
                       {"device", device},
                       {"usable", driver.usable},
                       {"software", driver.usable ? Json(driver.software) : Json()},
                       {"findings", list}};
    // Variables and messages of libraries may have bytes that are no UTF-8.
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace knuckle
