/// A picture made from a formula as the desk's tools read pictures.
#pragma once

#include "host_sim/png_file.hpp"
#include "tests/support/perception/synthetic_picture.hpp"

namespace tedavis::test_support {

inline host_sim::RgbaPicture rgba_of(const SyntheticPicture& picture) {
    host_sim::RgbaPicture out{static_cast<std::uint32_t>(picture.width), static_cast<std::uint32_t>(picture.height), {}};
    for (std::size_t n = 0; n < picture.pixels.size(); n += 3) {
        out.pixels.insert(out.pixels.end(), {picture.pixels[n], picture.pixels[n + 1], picture.pixels[n + 2], 255});
    }
    return out;
}

}  // namespace tedavis::test_support
