#include "tests/support/data.hpp"

#include <cstdlib>
#include <string>

namespace autostereo::test {

std::filesystem::path dataDir() {
    if (const char* fromEnvironment = std::getenv("AUTOSTEREO_DATA")) return fromEnvironment;
    return AUTOSTEREO_DATA_DEFAULT;
}

std::filesystem::path sourceDir() { return AUTOSTEREO_SOURCE_DIR; }

bool required(const char* what) {
    const char* list = std::getenv("AUTOSTEREO_REQUIRE");
    return list != nullptr &&
           (',' + std::string(list) + ',').find(',' + std::string(what) + ',') != std::string::npos;
}

bool fullCampaign() { return std::getenv("AUTOSTEREO_FULL") != nullptr; }

} // namespace autostereo::test
