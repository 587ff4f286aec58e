/// The design that a run is drawn with: the file, the palettes and bases that it names, and what the command line puts above it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host_sim/options/picture_options.hpp"
#include "host_sim/replay/design_files.hpp"
#include "render_core/design/phase_designs.hpp"

namespace tedavis::host_sim {

/// Path of the design file, short names resolved. Throws UserError where there is none.
[[nodiscard]] std::string design_path(const PictureOptions& options);
/// Throws UserError with file and line. `files`, where given, receives the files that were read, also when the design is not
/// valid.
[[nodiscard]] design::DesignSettings load_design(const PictureOptions& options, std::vector<ReadFile>* files = nullptr);

/// A design, and those that it names for phases; options of the command line override all of them.
struct LoadedDesigns {
    design::DesignSettings design;
    design::PhaseDesigns phases;
};
/// Loads them as load_design() does.
[[nodiscard]] std::unique_ptr<LoadedDesigns> load_designs(const PictureOptions& options, std::vector<ReadFile>* files = nullptr);

}  // namespace tedavis::host_sim
