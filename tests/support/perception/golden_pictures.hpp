/// Pictures of the display, from tests/golden.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "host_sim/png_file.hpp"
#include "tests/support/perception/synthetic_picture.hpp"

namespace tedavis::test_support {

struct NamedPicture {
    std::string name;
    SyntheticPicture picture;
};

/// In the order of their names.
inline std::vector<NamedPicture> golden_pictures(const std::string& source_folder) {
    std::vector<std::string> paths;
    for (const auto& file : std::filesystem::directory_iterator(source_folder + "/tests/golden/pictures"))
        if (file.path().extension() == ".png") paths.push_back(file.path().string());
    std::sort(paths.begin(), paths.end());
    std::vector<NamedPicture> pictures;
    for (const std::string& path : paths) {
        const host_sim::RgbaPicture png = host_sim::read_png(path);
        const auto color = [&](int x, int y) {
            const std::uint8_t* pixel =
                png.pixels.data() + 4 * (png.width * static_cast<std::size_t>(y) + static_cast<std::size_t>(x));
            return Rgb{pixel[0], pixel[1], pixel[2]};
        };
        pictures.push_back(
            {std::filesystem::path(path).stem().string(), {static_cast<int>(png.width), static_cast<int>(png.height), color}});
    }
    return pictures;
}

}  // namespace tedavis::test_support
