#include "host_sim/replay/design_files.hpp"

#include <utility>

#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

design::Palette palette_from_text(const std::string& text, const std::string& path) {
    const auto palette = design::read_palette(text, path);
    if (!palette.ok()) throw UserError(std::string(palette.error().message.view()));
    return palette.value();
}

std::string named_palette(const base::StatedFile& palette, const DesignFolders& folders) {
    const std::string name(palette.name);
    if (!design::is_short_name(name)) return path_from(std::string(palette.stated_in), name);
    return folders.shipped ? resolve_config(name, "palettes") : folders.palettes + name + ".toml";
}

std::string named_design(const base::StatedFile& design, const DesignFolders& folders) {
    const std::string name(design.name), stated_in(design.stated_in);
    if (folders.shipped) return stated_config(name, "designs", stated_in);
    if (!design::is_short_name(name)) return path_from(stated_in, name);
    return folders.designs.empty() ? path_from(stated_in, name + ".toml") : folders.designs + name + ".toml";
}

const ReadFile& DesignFiles::read(std::string path) {
    files_.push_back({std::move(path), ""});
    files_.back().text = read_file(files_.back().path);
    return files_.back();
}

base::Result<design::Palette, base::Error> DesignFiles::find(const base::StatedFile& palette) {
    try {
        const ReadFile& file = read(named_palette(palette, folders_));
        return palette_from_text(file.text, file.path);
    } catch (const UserError& error) {
        return base::fail(base::Error{error.what()});
    }
}

base::Result<design::DesignText, base::Error> DesignFiles::find_design(const base::StatedFile& design) {
    try {
        const ReadFile& file = read(named_design(design, folders_));
        return design::DesignText{file.text, file.path};
    } catch (const UserError& error) {
        return base::fail(base::Error{error.what()});
    }
}

}  // namespace tedavis::host_sim
