#pragma once

#include <string>

namespace knuckle::test {

/// The message of the `Error` that `act` throws; empty if it throws none.
template <typename Error, typename Act>
std::string messageOf(Act act)
{
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace knuckle::test
