#include "tests/support/prometheus_text.hpp"

#include <cmath>
#include <limits>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace autostereo::test {

namespace {

class Reader {
  public:
    Samples read(const std::string& text) {
        if (!text.ends_with('\n')) fail("the last line does not end");
        std::istringstream in(text);
        while (std::getline(in, line_))
            line_.starts_with('#') ? comment() : sample();
        endFamily();
        return samples_;
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        throw std::runtime_error(why + ": " + line_);
    }

    void comment() {
        static const std::regex help("# HELP ([a-zA-Z_:][a-zA-Z0-9_:]*) (.+)");
        static const std::regex type("# TYPE ([a-zA-Z_:][a-zA-Z0-9_:]*) "
                                     "(counter|gauge|histogram)");
        std::smatch found;
        if (std::regex_match(line_, found, help)) {
            endFamily();
            family_ = found[1];
            if (!families_.insert(family_).second) fail("a family twice");
        } else if (std::regex_match(line_, found, type)) {
            if (found[1] != family_ || !type_.empty()) fail("# TYPE without its # HELP");
            type_ = found[2];
            if ((type_ == "counter") != family_.ends_with("_total")) fail("name and type differ");
        } else {
            fail("no comment of this format");
        }
    }

    void sample() {
        static const std::regex whole(
            R"RE(([a-zA-Z_:][a-zA-Z0-9_:]*)(\{[a-zA-Z_][a-zA-Z0-9_]*="(?:[^"\\]|\\[\\"n])*")RE"
            R"RE((?:,[a-zA-Z_][a-zA-Z0-9_]*="(?:[^"\\]|\\[\\"n])*")*\})? (\S+))RE");
        std::smatch found;
        if (type_.empty()) fail("a sample before its # TYPE");
        if (!std::regex_match(line_, found, whole)) fail("no sample");
        const std::string name = found[1], labels = found[2];
        const double value = numberOf(found[3]);
        if (!samples_.emplace(name + labels, value).second) fail("a sample twice");
        if (type_ == "histogram")
            histogram(name, labels, value);
        else if (name != family_)
            fail("a sample of another family");
        if (type_ == "counter" && (value < 0 || value != std::floor(value))) fail("no count");
    }

    void histogram(const std::string& name, const std::string& labels, double value) {
        static const std::regex bound(R"RE(\{le="([^"]+)"\})RE");
        std::smatch found;
        if (name == family_ + "_bucket" && std::regex_match(labels, found, bound)) {
            const double upTo =
                found[1] == "+Inf" ? std::numeric_limits<double>::infinity() : numberOf(found[1]);
            if (upTo <= bound_ || value < count_) fail("buckets do not rise");
            bound_ = upTo;
            count_ = value;
        } else if (name == family_ + "_count") {
            if (!std::isinf(bound_) || value != count_) fail("_count is not the last bucket");
        } else if (name != family_ + "_sum") {
            fail("no part of a histogram");
        }
    }

    [[nodiscard]] double numberOf(const std::string& text) const {
        std::size_t end = 0;
        double value = 0;
        try {
            value = std::stod(text, &end);
        } catch (const std::logic_error&) {
            fail("no number");
        }
        if (end != text.size() || !std::isfinite(value)) fail("no number");
        return value;
    }

    void endFamily() {
        if (!family_.empty() && type_.empty()) fail("a family without # TYPE");
        family_.clear();
        type_.clear();
        bound_ = -std::numeric_limits<double>::infinity();
        count_ = 0;
    }

    std::string line_, family_, type_;
    double bound_ = 0, count_ = 0; ///< of the last bucket
    std::set<std::string> families_;
    Samples samples_;
};

} // namespace

Samples prometheusSamples(const std::string& text) { return Reader().read(text); }

} // namespace autostereo::test
