#include "host_sim/replay/palette_files.hpp"

#include <filesystem>

#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

design::Palette palette_from_text(const std::string& text, const std::string& path) {
    const auto palette = design::read_palette(text, path);
    if (!palette.ok()) throw UserError(std::string(palette.error().message.view()));
    return palette.value();
}

base::Result<design::Palette, base::Error> PaletteFiles::find(std::string_view name) {
    const std::string beside = (std::filesystem::path(design_path_).parent_path() / name).string();
    try {
        files_.push_back({design::is_short_name(name) ? resolve_config(std::string(name), "palettes") : beside, ""});
        ReadFile& file = files_.back();
        file.text = read_file(file.path);
        return palette_from_text(file.text, file.path);
    } catch (const UserError& error) {
        return base::fail(base::Error{error.what()});
    }
}

}  // namespace tedavis::host_sim
