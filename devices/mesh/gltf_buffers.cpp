#include "devices/mesh/gltf_buffers.hpp"

#include <array>
#include <charconv>
#include <cstring>
#include <string_view>

namespace autostereo::devices::mesh {

namespace {

enum Component : std::size_t {
    Int8 = 5120,
    Uint8 = 5121,
    Int16 = 5122,
    Uint16 = 5123,
    Uint32 = 5125,
    Float = 5126
};

std::size_t bytesOf(std::size_t component) {
    switch (component) {
    case Int8:
    case Uint8:
        return 1;
    case Int16:
    case Uint16:
        return 2;
    case Uint32:
    case Float:
        return 4;
    default:
        throw DeviceError("componentType = '" + std::to_string(component) +
                          "' (allowed 5120 to 5123, 5125, 5126)");
    }
}

std::size_t componentsOf(const std::string& type) {
    constexpr std::array<std::string_view, 4> kTypes{"SCALAR", "VEC2", "VEC3", "VEC4"};
    for (std::size_t i = 0; i < kTypes.size(); ++i)
        if (type == kTypes[i]) return i + 1;
    throw DeviceError("type = '" + type.substr(0, 40) + "' (allowed SCALAR, VEC2, VEC3, VEC4)");
}

template<class Value>
Value at(const std::byte* bytes) {
    Value value{};
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

float asFloat(const std::byte* bytes, std::size_t component, bool normalised) {
    const auto share = [&](double value, double most) {
        return static_cast<float>(normalised ? std::max(value / most, -1.0) : value);
    };
    switch (component) {
    case Int8:
        return share(at<std::int8_t>(bytes), 127);
    case Uint8:
        return share(at<std::uint8_t>(bytes), 255);
    case Int16:
        return share(at<std::int16_t>(bytes), 32767);
    case Uint16:
        return share(at<std::uint16_t>(bytes), 65535);
    case Uint32:
        return share(at<std::uint32_t>(bytes), 4294967295.0);
    default:
        return at<float>(bytes);
    }
}

int digitOf(char letter) {
    if (letter >= 'A' && letter <= 'Z') return letter - 'A';
    if (letter >= 'a' && letter <= 'z') return letter - 'a' + 26;
    if (letter >= '0' && letter <= '9') return letter - '0' + 52;
    if (letter == '+' || letter == '-') return 62;
    return letter == '/' || letter == '_' ? 63 : -1;
}

std::vector<std::byte> fromBase64(std::string_view text) {
    while (text.ends_with('='))
        text.remove_suffix(1);
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int held = 0;
    for (const char letter : text) {
        const int digit = digitOf(letter);
        if (digit < 0) throw DeviceError("data: holds what is no base64");
        bits = bits << 6U | static_cast<std::uint32_t>(digit);
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes.push_back(static_cast<std::byte>(bits >> static_cast<unsigned>(held) & 0xffU));
    }
    return bytes;
}

/// %20 and the like, as glTF's addresses have them.
std::string withoutEscapes(const std::string& uri) {
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned value = 0;
        const bool isEscape =
            uri[i] == '%' && i + 2 < uri.size() &&
            std::from_chars(&uri[i + 1], &uri[i + 1] + 2, value, 16).ptr == &uri[i + 1] + 2;
        name += isEscape ? static_cast<char>(value) : uri[i];
        if (isEscape) i += 2;
    }
    return name;
}

} // namespace

/// Where an accessor's values lie; `first` has room for all of them.
struct GltfBuffers::Elements {
    const std::byte* first;
    std::size_t count, components, stride, component;
    bool normalised;
};

GltfBuffers::GltfBuffers(const MeshFile& file, const Json& document,
                         std::span<const std::byte> chunk)
    : file_(file), document_(document) {
    constexpr std::size_t kMostBuffers = 256;
    std::size_t all = 0;
    for (const Json& buffer : list(document, "buffers", kMostBuffers)) {
        const std::string uri = text(buffer, "uri");
        owned_.push_back(uri.empty() ? std::vector<std::byte>{} : fetch(uri));
        const std::span<const std::byte> bytes = uri.empty() ? chunk : owned_.back();
        const std::size_t wanted = whole(buffer, "byteLength", file.limits.fileBytes);
        if (wanted > bytes.size())
            throw DeviceError("byteLength = '" + std::to_string(wanted) +
                              "' of a buffer that has " + std::to_string(bytes.size()) + " bytes");
        all += owned_.back().size();
        allow(all, file.limits.fileBytes, "bytes in buffers");
        buffers_.push_back(bytes.first(wanted));
    }
}

std::vector<std::byte> GltfBuffers::fetch(const std::string& uri) const {
    constexpr std::string_view kBase64 = ";base64,";
    if (uri.starts_with("data:")) {
        const std::size_t comma = uri.find(kBase64);
        if (comma == std::string::npos) throw DeviceError("data: is not base64");
        return fromBase64(std::string_view(uri).substr(comma + kBase64.size()));
    }
    return file_.folder.read(withoutEscapes(uri));
}

std::span<const std::byte> GltfBuffers::view(std::size_t index) const {
    const Json& views = list(document_, "bufferViews", kMostEntries);
    if (index >= views.size())
        throw DeviceError("bufferView " + std::to_string(index) + " is missing");
    const Json& view = views[index];
    const auto& buffer = buffers_.at(whole(view, "buffer", buffers_.size()));
    const std::size_t offset = whole(view, "byteOffset", buffer.size() + 1, 0);
    return buffer.subspan(offset, whole(view, "byteLength", buffer.size() - offset + 1));
}

GltfBuffers::Elements GltfBuffers::elements(std::size_t index, std::size_t most) const {
    const Json& accessors = list(document_, "accessors", kMostEntries);
    if (index >= accessors.size())
        throw DeviceError("accessor " + std::to_string(index) + " is missing");
    const Json& accessor = accessors[index];
    if (member(accessor, "sparse") != nullptr)
        throw DeviceError("accessor " + std::to_string(index) + " is sparse: not read");
    const std::size_t viewIndex = whole(accessor, "bufferView", kMostEntries);
    const std::span<const std::byte> bytes = view(viewIndex);
    const std::size_t component = whole(accessor, "componentType", 65536);
    const std::size_t components = componentsOf(text(accessor, "type"));
    const std::size_t size = components * bytesOf(component);
    const std::size_t offset = whole(accessor, "byteOffset", bytes.size() + 1, 0);
    const std::size_t count = whole(accessor, "count", most + 1);
    const Json& viewJson = list(document_, "bufferViews", kMostEntries)[viewIndex];
    const std::size_t stride = whole(viewJson, "byteStride", 65536, size);
    if (count > 0 && (stride < size || bytes.size() - offset < size ||
                      count - 1 > (bytes.size() - offset - size) / stride))
        throw DeviceError("accessor " + std::to_string(index) + " reaches beyond its buffer view");
    const Json* const normalised = member(accessor, "normalized");
    return {bytes.data() + offset,
            count,
            components,
            stride,
            component,
            normalised != nullptr && *normalised == true};
}

GltfValues GltfBuffers::values(std::size_t index, std::size_t most) const {
    const Elements all = elements(index, most);
    GltfValues read{all.count, all.components, {}};
    read.values.reserve(all.count * all.components);
    const std::size_t size = bytesOf(all.component);
    for (std::size_t i = 0; i < all.count; ++i)
        for (std::size_t c = 0; c < all.components; ++c)
            read.values.push_back(
                asFloat(all.first + i * all.stride + c * size, all.component, all.normalised));
    return read;
}

std::vector<std::uint32_t> GltfBuffers::indices(std::size_t index, std::size_t most) const {
    const Elements all = elements(index, most);
    std::vector<std::uint32_t> read;
    read.reserve(all.count);
    for (std::size_t i = 0; i < all.count; ++i) {
        const std::byte* const place = all.first + i * all.stride;
        if (all.component == Uint8)
            read.push_back(at<std::uint8_t>(place));
        else if (all.component == Uint16)
            read.push_back(at<std::uint16_t>(place));
        else if (all.component == Uint32)
            read.push_back(at<std::uint32_t>(place));
        else
            throw DeviceError("accessor " + std::to_string(index) + " holds no indices");
    }
    return read;
}

} // namespace autostereo::devices::mesh
