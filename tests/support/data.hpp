#pragma once

#include <filesystem>

namespace autostereo::test {

/// Folder with real recordings: $AUTOSTEREO_DATA, else the one found at configuration.
[[nodiscard]] std::filesystem::path dataDir();

/// The project's own folder, for tests that read what it ships.
[[nodiscard]] std::filesystem::path sourceDir();

/// True when $AUTOSTEREO_REQUIRE (a comma-separated list) names `what`: skipping is no option.
[[nodiscard]] bool required(const char* what);

/// True for `tests/run --full` ($AUTOSTEREO_FULL): campaigns run at full length.
[[nodiscard]] bool fullCampaign();

} // namespace autostereo::test

/// Skips a test with a reason a person can read; with AUTOSTEREO_REQUIRE=data (CI) it fails.
#define AUTOSTEREO_NEED_DATA(relative)                                                             \
    do {                                                                                           \
        if (!std::filesystem::exists(autostereo::test::dataDir() / (relative))) {                  \
            if (autostereo::test::required("data"))                                                \
                FAIL() << "test data missing: " << (autostereo::test::dataDir() / (relative));     \
            GTEST_SKIP() << "test data missing: " << (autostereo::test::dataDir() / (relative));   \
        }                                                                                          \
    } while (false)
