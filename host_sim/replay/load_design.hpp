/// Loads the design of a run: the file, the palettes and bases that it names, and the options of the command line that override
/// it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host_sim/options/picture_options.hpp"
#include "host_sim/replay/design_files.hpp"
#include "render_core/design/phase_designs.hpp"

namespace tedavis::host_sim {

/// Returns the path of the design file; resolves short names. Throws UserError where there is no such file.
[[nodiscard]] std::string design_path(const PictureOptions& options);
/// Throws UserError with file and line. `files`, where given, receives the files that were read, also when the design is not
/// valid.
[[nodiscard]] design::DesignSettings load_design(const PictureOptions& options, std::vector<ReadFile>* files = nullptr);

/// A design and those that it names for phases, all with the overriding options of the command line.
struct LoadedDesigns {
    design::DesignSettings design;
    design::PhaseDesigns phases;
};
/// Loads a design and those that it names for phases, as load_design() does.
[[nodiscard]] std::unique_ptr<LoadedDesigns> load_designs(const PictureOptions& options, std::vector<ReadFile>* files = nullptr);

}  // namespace tedavis::host_sim
