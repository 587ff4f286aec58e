#include "host_sim/replay/load_design.hpp"

#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

std::string design_path(const PictureOptions& options) { return resolve_config(options.design, "designs"); }

design::DesignSettings design_from_text(const std::string& text, const PictureOptions& options) {
    auto design = design::read_design_settings(text, design_path(options));
    if (!design.ok()) throw UserError(std::string(design.error().sentence.view()));
    if (options.tau_px) design.value().terrain.tau_px = *options.tau_px;
    return design.value();
}

design::DesignSettings load_design(const PictureOptions& options) {
    return design_from_text(read_file(design_path(options)), options);
}

}  // namespace tedavis::host_sim
