#include "config/load.hpp"
#include "daemon/control/control_request.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own entry

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) try {
    const auto request = daemon::parseRequest(fuzz::textOf(data, size));
    // What is understood is understood again when it is passed on.
    const std::string line = daemon::requestLine(request);
    fuzz::require(line.find('\n') == std::string::npos, "a request of lines");
    if (line.size() <= daemon::kLongestRequest)
        fuzz::require(daemon::parseRequest(line).index() == request.index(), "another request");
    // And a value is a value, whatever it looks like.
    if (const auto* set = std::get_if<daemon::SetRequest>(&request)) {
        const config::Config before;
        const config::Config after = config::changed(before, set->name, set->value);
        fuzz::require(after.input == before.input, "a setting that changes the input");
    }
    return 0;
} catch (const daemon::RequestError& error) {
    fuzz::requirePlain(error.what());
    return 0;
} catch (const config::ConfigError& error) {
    fuzz::requirePlain(error.what());
    return 0;
}
