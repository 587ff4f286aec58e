#include "tests/support/files/device_files.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/files/paths.hpp"

namespace tedavis::test_support {

std::string source_file(const std::string& path_from_root) {
    const std::string path = test_support::source_dir() + "/" + path_from_root;
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        std::fprintf(stderr, "the test needs %s\n", path.c_str());
        std::abort();
    }
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

effects::DeviceSettings shipped_device(const std::string& name) {
    const std::string path = "configs/devices/" + name + ".toml";
    const auto device = effects::read_device_settings(source_file(path), path);
    if (!device) {
        std::fprintf(stderr, "%s\n", device.error().message.c_str());
        std::abort();
    }
    return device.value();
}

base::Result<design::Palette, base::Error> ShippedFiles::find(const base::StatedFile& palette) {
    const std::string path = "configs/palettes/" + std::string(palette.name) + ".toml";
    return design::read_palette(source_file(path), path);
}

base::Result<design::DesignText, base::Error> ShippedFiles::find_design(const base::StatedFile& design) {
    const std::string name(design.name);
    const std::filesystem::path folder = std::filesystem::path(design.stated_in).parent_path();
    path_ = design::is_short_name(name) ? "configs/designs/" + name + ".toml" : (folder / name).lexically_normal().string();
    text_ = source_file(path_);
    return design::DesignText{text_, path_};
}

design::DesignSettings shipped_design(const std::string& name) {
    const std::string path = "configs/designs/" + name + ".toml";
    ShippedFiles files;
    const auto design = design::read_design_settings(source_file(path), path, files);
    if (!design) {
        std::fprintf(stderr, "%s\n", design.error().message.c_str());
        std::abort();
    }
    return design.value();
}

}  // namespace tedavis::test_support
