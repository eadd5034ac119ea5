#pragma once

#include <string>
#include <string_view>

namespace knuckle {

/// Whether an address can be reached from this machine alone: 127.x.x.x, ::1 or localhost.
bool isLoopback(std::string_view host);
/// The name in a Host header, without a port and an address's brackets.
std::string nameOfHost(std::string_view header);
/// Whether an Origin header is of the site that a Host header names; an absent one (empty) is of no other.
bool isOwnOrigin(std::string_view origin, std::string_view host);
/// Whether a Sec-Fetch-Site header is that of a page of another site; absent (empty): not of a browser.
bool isOfAnotherSite(std::string_view fetchSite);
/// Takes as long wherever two texts differ.
bool isSameSecret(std::string_view given, std::string_view secret);

}  // namespace knuckle
