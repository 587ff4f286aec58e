/// Draws pictures with the whole legend for the report of a run, whose own pictures show only the key.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/replay/display_session.hpp"
#include "host_sim/reports/frame_record_json.hpp"
#include "host_sim/reports/run_story.hpp"
#include "render_core/flight/frame_input.hpp"

namespace tedavis::host_sim {

class LegendPictures {
public:
    static constexpr std::size_t kMaxDesigns = 8;

    /// Keeps one frame of each design, the second one if there is one. Frames of designs beyond kMaxDesigns are only counted.
    void note(const std::string& design, const FrameResult& result, const flight::FrameInput& input);
    [[nodiscard]] std::uint64_t frames_left_out() const { return frames_left_out_; }

    /// Draws the kept frames again with the whole legend and adds them to the story. Afterwards the session holds the last of
    /// these pictures.
    void draw(DisplaySession& session, RunStory& story) const;

private:
    struct Kept {
        std::string design;
        std::uint64_t frames = 0;  ///< of this design so far
        FrameResult result;
        flight::FrameInput input;  ///< without its trail, which belongs to a later instant when this is drawn
    };

    std::vector<Kept> kept_;
    std::uint64_t frames_left_out_ = 0;
};

}  // namespace tedavis::host_sim
