#pragma once

#include <string>

#include "app/doctor/driver_findings.h"

namespace knuckle {

/// What `knuckle doctor --json` prints, of all findings; docs/output.md. @param device as `--device` named it.
std::string findingsAsJson(const Findings& findings, const DriverFindings& driver, const std::string& device);

}  // namespace knuckle
