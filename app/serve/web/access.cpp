#include "app/serve/web/access.h"

#include <cstddef>

namespace knuckle {

bool isLoopback(std::string_view host)
{
    if (host == "localhost" || host == "::1") return true;
    // Only digits and dots: 127.0.0.1.example.org is a name that anybody may own.
    return host.starts_with("127.") && host.find_first_not_of("0123456789.") == std::string_view::npos;
}

std::string nameOfHost(std::string_view header)
{
    if (header.starts_with('[')) return std::string(header.substr(1, header.find(']') - 1));
    return std::string(header.substr(0, header.find(':')));
}

bool isOwnOrigin(std::string_view origin, std::string_view host)
{
    if (origin.empty()) return true;
    for (const std::string_view scheme : {"http://", "https://"})
        if (origin.starts_with(scheme)) return origin.substr(scheme.size()) == host;
    return false;
}

bool isOfAnotherSite(std::string_view fetchSite)
{
    return fetchSite == "cross-site" || fetchSite == "same-site";
}

bool isSameSecret(std::string_view given, std::string_view secret)
{
    size_t different = given.size() ^ secret.size();
    for (size_t k = 0; k < secret.size(); ++k) {
        const char other = given.empty() ? '\0' : given[k % given.size()];
        different |= static_cast<unsigned char>(other ^ secret[k]);
    }
    return different == 0;
}

}  // namespace knuckle
