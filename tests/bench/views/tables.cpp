#include "tests/bench/views/row.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <sstream>

namespace autostereo::bench {

std::string json(const std::vector<Row>& rows) {
    auto list = nlohmann::json::array();
    for (const Row& row : rows)
        list.push_back({{"suite", row.suite},
                        {"scene", row.scene},
                        {"display", row.display},
                        {"grid", row.grid},
                        {"views", row.views},
                        {"method", row.method},
                        {"wall_ms", row.wallMs},
                        {"cpu_ms", row.cpuMs},
                        {"gpu_ms", row.gpuMs},
                        {"psnr_db", row.psnrDb},
                        {"ssim", row.ssim},
                        {"err_max", row.errMax},
                        {"bad_pct", row.badPct},
                        {"mem_mib", row.memMib},
                        {"ratio_to_multipass", row.ratioToMultipass}});
    return list.dump(2) + '\n';
}

std::string markdown(const std::vector<Row>& rows) {
    std::ostringstream text;
    text << std::fixed;
    const Row* last = nullptr;
    for (const Row& row : rows) {
        if (last == nullptr || last->display != row.display || last->grid != row.grid ||
            last->views != row.views || last->scene != row.scene)
            text << "\n"
                 << row.scene << " " << row.grid << ", " << row.display << ", " << row.views
                 << " views\n\n| method | wall ms | CPU ms | times multipass | dB | SSIM | max | "
                    "> 16/255 % | MiB |\n|---|---|---|---|---|---|---|---|---|\n";
        text << "| " << row.method << std::setprecision(0) << " | " << row.wallMs << " | "
             << row.cpuMs << std::setprecision(2) << " | " << row.ratioToMultipass
             << std::setprecision(1) << " | " << row.psnrDb << std::setprecision(4) << " | "
             << row.ssim << std::setprecision(0) << " | " << row.errMax << std::setprecision(3)
             << " | " << row.badPct << std::setprecision(1) << " | " << row.memMib << " |\n";
        last = &row;
    }
    return text.str();
}

namespace {

constexpr int kWidth = 720, kHeight = 420, kLeft = 60, kRight = 20, kTop = 40, kBottom = 50;

/// A decade of CPU time to a place, and 20 to 65 dB.
struct Axes {
    double leastMs, mostMs;

    [[nodiscard]] double x(double ms) const {
        const double share = std::log(ms / leastMs) / std::log(mostMs / leastMs);
        return kLeft + share * (kWidth - kLeft - kRight);
    }
    [[nodiscard]] static double y(double db) {
        const double share = (std::clamp(db, 20.0, 65.0) - 20) / 45;
        return kHeight - kBottom - share * (kHeight - kTop - kBottom);
    }
};

/// A text as XML has it: addresses have ampersands.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text)
        out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
    return out;
}

void drawFrame(std::ostream& svg, const Axes& axes, const Row& about) {
    svg << R"(<rect width="100%" height="100%" fill="white"/>)"
        << "<text x=\"" << kLeft << "\" y=\"22\" font-size=\"11\">" << escaped(about.scene) << " "
        << about.grid << ", " << about.display << ", " << about.views << " views</text>\n";
    for (int db = 20; db <= 60; db += 10)
        svg << "<line x1=\"" << kLeft << "\" x2=\"" << kWidth - kRight << "\" y1=\"" << Axes::y(db)
            << "\" y2=\"" << Axes::y(db) << "\" stroke=\"#ddd\"/><text x=\"" << kLeft - 8
            << "\" y=\"" << Axes::y(db) + 4 << "\" text-anchor=\"end\">" << db << "</text>\n";
    for (double ms = std::pow(10, std::floor(std::log10(axes.leastMs))); ms <= axes.mostMs;
         ms *= 10)
        for (const double part : {1.0, 3.0}) {
            if (part * ms < axes.leastMs || part * ms > axes.mostMs) continue;
            svg << "<line x1=\"" << axes.x(part * ms) << "\" x2=\"" << axes.x(part * ms)
                << "\" y1=\"" << kTop << "\" y2=\"" << kHeight - kBottom
                << "\" stroke=\"#ddd\"/><text x=\"" << axes.x(part * ms) << "\" y=\""
                << kHeight - kBottom + 16 << "\" text-anchor=\"middle\">" << part * ms
                << "</text>\n";
        }
    svg << "<text x=\"" << (kLeft + kWidth) / 2 << "\" y=\"" << kHeight - 12
        << "\" text-anchor=\"middle\">CPU time, ms</text><text x=\"16\" y=\"" << kTop - 8
        << "\">dB</text>\n";
}

/// Names beside their points, one below the other where they would overlap.
class Labels {
  public:
    void draw(std::ostream& svg, double x, double y, const std::string& name) {
        constexpr double kLetter = 6.5, kLine = 14;
        const double right = x + 8 + kLetter * static_cast<double>(name.size());
        double top = y;
        for (bool moved = true; moved;) {
            moved = false;
            for (const Box& other : boxes_)
                if (x < other.right && right > other.left && std::abs(top - other.y) < kLine) {
                    top = other.y + kLine;
                    moved = true;
                }
        }
        boxes_.push_back({x, right, top});
        if (top != y)
            svg << "<line x1=\"" << x << "\" y1=\"" << y << "\" x2=\"" << x + 7 << "\" y2=\"" << top
                << "\" stroke=\"#999\"/>";
        svg << "<text x=\"" << x + 8 << "\" y=\"" << top + 4 << "\">" << name << "</text>\n";
    }

  private:
    struct Box {
        double left, right, y;
    };
    std::vector<Box> boxes_;
};

} // namespace

std::string plot(const std::vector<Row>& rows) {
    Axes axes{1e9, 0};
    for (const Row& row : rows) {
        axes.leastMs = std::min(axes.leastMs, row.cpuMs / 1.5);
        axes.mostMs = std::max(axes.mostMs, row.cpuMs * 3);
    }
    std::ostringstream svg;
    svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << kWidth << "\" height=\""
        << kHeight << "\" font-family=\"sans-serif\" font-size=\"12\">\n";
    drawFrame(svg, axes, rows.front());
    Labels labels;
    for (const Row& row : rows) {
        if (row.method.starts_with("auto")) continue; // one of the others
        const bool direct = row.method.starts_with("direct");
        const double x = axes.x(row.cpuMs), y = Axes::y(row.psnrDb);
        svg << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"5\" fill=\""
            << (direct ? "#c22" : "#269") << "\"/>";
        labels.draw(svg, x, y, row.method);
    }
    svg << "</svg>\n";
    return svg.str();
}

} // namespace autostereo::bench
