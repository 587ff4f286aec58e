#include "host_sim/pack/packed_designs.hpp"

#include <filesystem>
#include <utility>

#include "host_sim/input_file.hpp"
#include "host_sim/replay/design_files.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/design/phase_designs.hpp"

namespace tedavis::host_sim {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_place(const base::StatedFile& stated, const char* why) {
    throw UserError(std::string(stated.stated_in) + ": names " + std::string(stated.name) + ", " + why);
}

void require_sound_design(const base::Result<design::DesignSettings, base::Error>& read) {
    if (!read.ok()) throw UserError(std::string(read.error().message.view()));
}

}  // namespace

std::string PackedDesigns::place_of(const base::StatedFile& stated, const std::string& folder) const {
    const std::string name(stated.name);
    if (!name.empty() && name.front() == '/')
        refuse_place(stated, "a path that holds on this machine alone; name it from the design's folder");
    const bool is_short = design::is_short_name(name);
    const std::string file = is_short ? name + ".toml" : name;
    const std::string naming = places_.at(std::string(stated.stated_in));
    const fs::path from = is_short && !folder.empty() ? fs::path(folder) : fs::path(naming).parent_path();
    std::string place = (from / file).lexically_normal().generic_string();
    if (place.rfind("..", 0) == 0)
        refuse_place(stated,
                     "which lies more than one folder above; a pack keeps the design's folder and its neighbours, so move it");
    return place;
}

std::string PackedDesigns::take(const std::string& file, const std::string& place) {
    std::string text = read_file(file);
    add_packed({file, place, {}, {}, {}}, files_);
    places_[file] = place;
    return text;
}

std::string PackedDesigns::add(const std::string& design_file) {
    std::string place = kPackedDesign + fs::path(design_file).filename().string();
    const std::string text = take(design_file, place);
    design::NamedPhases phases;
    require_sound_design(design::read_design_settings(text, design_file, *this, &phases));
    for (const design::NamedPhase& named : phases) {
        const auto found = find_design({named.design.view(), design_file});
        if (!found.ok()) throw UserError(std::string(found.error().message.view()));
        const std::string of_phase = text_, file = path_;
        design::NamedPhases nested;
        require_sound_design(design::read_design_settings(of_phase, file, *this, &nested));
        if (!nested.empty())
            throw UserError(file + ": " + design_file + " names it for a phase, so it has no table [phases]; remove it");
    }
    return place;
}

base::Result<design::Palette, base::Error> PackedDesigns::find(const base::StatedFile& palette) {
    try {
        const std::string file = named_palette(palette, folders_);
        const std::string text = take(file, place_of(palette, kPackedPalettes));
        return palette_from_text(text, file);
    } catch (const UserError& error) {
        return base::fail(base::Error{error.what()});
    }
}

base::Result<design::DesignText, base::Error> PackedDesigns::find_design(const base::StatedFile& design) {
    try {
        path_ = named_design(design, folders_);
        const bool has_folder = folders_.shipped || !folders_.designs.empty();
        text_ = take(path_, place_of(design, has_folder ? kPackedDesigns : ""));
        return design::DesignText{text_, path_};
    } catch (const UserError& error) {
        return base::fail(base::Error{error.what()});
    }
}

}  // namespace tedavis::host_sim
