#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>

namespace autostereo::devices {

/// An input address taken apart: `scheme:path?key=value&key=value`. Text without a scheme (lower
/// case letters and digits before the first colon) is a plain file name, query marks included.
/// No percent-decoding. Reentrant; everything that is wrong throws AddressError.
struct Uri {
    std::string text; ///< as given, for messages
    std::string scheme;
    std::string path;
    std::map<std::string, std::string> query;

    /// Refuses keys that are not in `allowed`, naming those that are.
    void allowOnly(std::initializer_list<std::string_view> allowed) const;
    /// The value of `key` as a number from `lowest` to `highest`, or `fallback` where it is absent.
    [[nodiscard]] double number(const std::string& key, double fallback, double lowest,
                                double highest) const;
    /// The value of `key`, empty where it is absent.
    [[nodiscard]] std::string value(const std::string& key) const;
};

[[nodiscard]] Uri parseUri(const std::string& text);

} // namespace autostereo::devices
