#pragma once

#include <string>
#include <vector>

namespace knuckle {

enum class Health {
    Ok,
    Note,  ///< Good to know; everything works all the same.
    Wrong  ///< Something that the program can do does not work here.
};

/// What `knuckle doctor` says in one line.
struct Finding {
    Health health = Health::Ok;
    std::string what;
    std::string remedy = {};  ///< What to do; empty: nothing.
};
using Findings = std::vector<Finding>;

/// Without the newline: "WRONG  what; remedy".
std::string lineOf(const Finding& finding);

}  // namespace knuckle
