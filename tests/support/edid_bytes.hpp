#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace autostereo::test {

using Bytes = std::vector<std::byte>;

inline Bytes bytesOfHex(std::string_view hex) {
    const auto digit = [](char c) {
        return static_cast<unsigned>(c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10);
    };
    Bytes bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes.push_back(static_cast<std::byte>(digit(hex[i]) << 4U | digit(hex[i + 1])));
    return bytes;
}

/// A Dell D2721H, 27 inch Full HD, on HDMI (published as a reference EDID for virtual monitors).
constexpr std::string_view kDell =
    "00ffffffffffff0010ac132045393639201e0103803c22782acd25a3574b9f27"
    "0d5054a54b00714f8180a9c0d1c00101010101010101023a801871382d40582c"
    "450056502100001e000000ff00335335475132330a2020202020000000fc0044"
    "454c4c204432373231480a20000000fd00384c1e5311000a2020202020200181"
    "02031ab14f90050403020716010611121513141f65030c001000023a80187138"
    "2d40582c450056502100001e011d8018711c1620582c250056502100009e011d"
    "007251d01e206e28550056502100001e8c0ad08a20e02d10103e960056502100"
    "001800000000000000000000000000000000000000000000000000000000004f";
/// An LG SDQHD, 28 inch, 2560 x 2880 (in the kernel's documentation of HDMI infoframes).
constexpr std::string_view kLg = "00ffffffffffff001e6df45b1eef060007200103802f3478ea2405af4f42ab25"
                                 "0f5054210800d1c0614045400101010101010101010198d00040a140d4b03020"
                                 "3a00d10b1200001a000000fd003b3d1eb231000a202020202020000000fc004c"
                                 "472053445148440a20202020000000ff003230374e54524c44433433300a0146"
                                 "02034272230907074d0103049012131f225d5e5f6061830100006d030c001000"
                                 "b83c20006001020367d85dc401788003e30f0018e2006ae305c000e606050152"
                                 "5251115d00a0a04029b030203a00d10b1200001a000000000000000000000000"
                                 "00000000000000000000000000000000000000000000000000000000000000c3";
/// A BOE NE135FBM notebook panel, 2256 x 1504: EDID 1.4 without a name or extensions.
constexpr std::string_view kBoe =
    "00ffffffffffff0009e55f0900000000171d0104a51c137803de50a3544c9926"
    "0f505400000001010101010101010101010101010101115cd01881e02d503020"
    "36001dbe1000001aa749d01881e02d50302036001dbe1000001a000000fe0042"
    "4f452043510a202020202020000000fe004e4531333546424d2d4e34310a00fb";

/// Makes a block's checksum right again.
inline void seal(Bytes& edid, std::size_t block = 0) {
    unsigned sum = 0;
    for (std::size_t i = 0; i < 127; ++i)
        sum += std::to_integer<unsigned>(edid[128 * block + i]);
    edid[128 * block + 127] = static_cast<std::byte>(256 - (sum & 0xffU));
}

/// A made-up monitor: this name and native size at 60 Hz, 120 x 160 mm, serial text "S1".
inline Bytes syntheticEdid(std::string_view name, unsigned width, unsigned height) {
    Bytes edid(128);
    const auto put = [&](std::size_t at, std::initializer_list<unsigned> values) {
        for (const unsigned value : values)
            edid[at++] = static_cast<std::byte>(value);
    };
    const auto putText = [&](std::size_t at, unsigned tag, std::string text) {
        put(at, {0, 0, 0, tag, 0});
        text += '\n';
        text.resize(13, ' ');
        for (std::size_t i = 0; i < 13; ++i)
            edid[at + 5 + i] = static_cast<std::byte>(text[i]);
    };
    put(0, {0, 255, 255, 255, 255, 255, 255, 0, 0x52, 0x62, 0x01, 0x02, 1, 0, 0, 0, 1, 33, 1, 4});
    put(20, {0xa5, 12, 16});
    const unsigned clock = (width + 160) * (height + 40) * 60 / 10000;
    put(54, {clock & 255U, clock >> 8U, width & 255U, 160, (width >> 8U) << 4U, height & 255U, 40,
             (height >> 8U) << 4U, 48, 32, 0x35, 0, 120, 160, 0, 0, 0, 0x1e});
    putText(72, 0xfc, std::string(name));
    putText(90, 0xff, "S1");
    seal(edid);
    return edid;
}

} // namespace autostereo::test
