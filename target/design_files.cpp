#include "target/design_files.hpp"

#include <utility>

namespace tedavis::target {
namespace {

constexpr const char* kTooLong = "its path is longer than 1023 bytes; use a shorter one";

}  // namespace

Path path_of_design(const base::StatedFile& design, const DesignFolders& folders) {
    const bool is_short = design::is_short_name(design.name);
    Path path = path_beside(is_short && !folders.designs.empty() ? folders.designs : design.stated_in, design.name);
    if (is_short) path.append(".toml");
    return path;
}

base::Result<design::Palette, base::Error> DesignFiles::find(const base::StatedFile& palette) {
    Path path;
    if (design::is_short_name(palette.name)) {
        path.append(folders_.palettes);
        path.append(palette.name);
        path.append(".toml");
    } else {
        path = path_beside(palette.stated_in, palette.name);
    }
    if (path.cut()) return base::fail(base::Error{kTooLong});
    const auto text = platform::read_file_text(path.c_str());
    if (!text.ok()) return base::fail(text.error());
    return design::read_palette(text.value().view(), path.view());
}

base::Result<design::DesignText, base::Error> DesignFiles::find_design(const base::StatedFile& design) {
    design_ = path_of_design(design, folders_);
    if (design_.cut()) return base::fail(base::Error{kTooLong});
    auto text = platform::read_file_text(design_.c_str());
    if (!text.ok()) return base::fail(text.error());
    text_ = std::move(text.value());
    return design::DesignText{text_.view(), design_.view()};
}

}  // namespace tedavis::target
