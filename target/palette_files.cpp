#include "target/palette_files.hpp"

#include "target/file_text.hpp"

namespace tedavis::target {

base::Result<design::Palette, base::Error> PaletteFiles::find(std::string_view name) {
    Path path;
    if (design::is_short_name(name)) {
        path.append(folder_);
        path.append(name);
        path.append(".toml");
    } else {
        path = path_beside(design_file_, name);
    }
    if (path.cut()) return base::fail(base::Error{"its path is longer than 1023 bytes; use a shorter one"});
    const auto text = read_file_text(path.c_str());
    if (!text.ok()) return base::fail(base::Error{text.error().message.view()});
    return design::read_palette(text.value().view(), path.view());
}

}  // namespace tedavis::target
