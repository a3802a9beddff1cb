#include "gpu/gl/shader_source.hpp"

#include "gpu/embedded_files.hpp"
#include "gpu/gl/error.hpp"

#include <algorithm>

namespace autostereo::gpu::gl {

namespace {

std::string_view embedded(std::string_view name) {
    const auto files = shaders::embeddedFiles();
    const auto found = std::find_if(files.begin(), files.end(),
                                    [&](const auto& file) { return file.name == name; });
    if (found == files.end()) throw GlError("gl: no shader named " + std::string(name));
    return found->text;
}

} // namespace

std::string shaderSource(std::string_view name, const std::vector<std::string>& defines) {
    constexpr std::string_view kInclude = "#include \"";
    constexpr std::size_t kMost = 1U << 20; // bytes of a shader with all that it includes
    std::string text(embedded(name));
    for (auto at = text.find(kInclude); at != std::string::npos; at = text.find(kInclude, at)) {
        const auto nameAt = at + kInclude.size();
        const auto end = text.find('"', nameAt);
        const auto included = embedded(std::string_view(text).substr(nameAt, end - nameAt));
        text.replace(at, end + 1 - at, included);
        if (text.size() > kMost)
            throw GlError("gl: shader " + std::string(name) + " includes itself");
    }
    std::string lines;
    for (const std::string& define : defines)
        lines += "#define " + define + '\n';
    text.insert(text.find('\n') + 1, lines); // behind #version
    return text;
}

} // namespace autostereo::gpu::gl
