#include "config/display_reader.hpp"

namespace autostereo::config {

std::string DisplayReader::origin(std::string_view key) {
    auto word = provenance.choice<std::string>(key, {{"per-unit", "per-unit"},
                                                     {"template", "template"},
                                                     {"measured", "measured"},
                                                     {"assumed", "assumed"}});
    profile.provenance.emplace(key, word);
    return word;
}

double DisplayReader::physical(TomlReader& table, std::string_view key, Range range) {
    origin(key);
    return table.number(key, range);
}

double DisplayReader::lensNumber(TomlReader& table, std::string_view key, Range range) {
    noteLensOrigin(key);
    return table.number(key, range);
}

void DisplayReader::noteLensOrigin(std::string_view key) {
    const std::string from = origin(key);
    if (from == "template" || from == "assumed") profile.placeholder = true;
}

} // namespace autostereo::config
