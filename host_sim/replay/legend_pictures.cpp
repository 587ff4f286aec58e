#include "host_sim/replay/legend_pictures.hpp"

#include <algorithm>

#include "render_core/display/preroll.hpp"
#include "render_core/draw/symbology/layout.hpp"

namespace tedavis::host_sim {
namespace {

/// Whether the display that a session shows has room for more than the key.
bool has_legend_rows(DisplaySession& session) {
    draw::LegendNeed need;
    need.keeps_column = true;
    return draw::make_layout(session.width(), session.height(), session.display().planned().shown->view.dpi, need)
        .has_legend_rows;
}

}  // namespace

void LegendPictures::note(const std::string& design, const FrameResult& result, const flight::FrameInput& input) {
    auto kept = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& other) { return other.design == design; });
    if (kept == kept_.end()) {
        if (kept_.size() == kMaxDesigns) {
            ++frames_left_out_;
            return;
        }
        kept = kept_.insert(kept_.end(), {design, 0, {}, {}});
    }
    if (++kept->frames > 2) return;
    kept->result = result;
    kept->input = input;
    kept->input.trail = nullptr;
    kept->input.legend = flight::LegendShow::whole;
}

void LegendPictures::draw(DisplaySession& session, RunStory& story) const {
    for (const Kept& kept : kept_) {
        display::settle(session.display(), kept.input);
        session.display().plan(kept.input);
        session.draw();
        story.add_legend(kept.design, has_legend_rows(session), kept.result, session.pixels());
    }
}

}  // namespace tedavis::host_sim
