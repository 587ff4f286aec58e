#include "host_sim/window/design_watch.hpp"

#include "host_sim/input_file.hpp"
#include "host_sim/replay/load_design.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

DesignWatch::DesignWatch(const PictureOptions& options)
    : options_(options), path_(design_path(options)), taken_(read_file(path_)), last_met_(taken_) {
    options_.design = path_;
    design_ = design_from_text(taken_, options_);
}

DesignNews DesignWatch::look() {
    std::string content;
    try {
        content = read_file(path_);
    } catch (const UserError&) {
        return DesignNews::none;  // editors take a file away for a moment while they save
    }
    const bool settled = content == last_met_;
    last_met_ = content;
    if (!settled || content == taken_) return DesignNews::none;
    taken_ = content;
    try {
        design_ = design_from_text(content, options_);
        return DesignNews::changed;
    } catch (const UserError& error) {
        sentence_ = error.what();
        return DesignNews::broken;
    }
}

}  // namespace tedavis::host_sim
