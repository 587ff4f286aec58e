/// Pictures of a run with the whole legend, for its report: the pictures of a flight show the key only.
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

    /// Keeps a frame of each design that the run shows: its second one where there is one.
    /// Designs beyond kMaxDesigns have no picture, and are counted.
    void note(const std::string& design, const FrameResult& result, const flight::FrameInput& input);
    [[nodiscard]] std::uint64_t frames_left_out() const { return frames_left_out_; }

    /// Draws them again with the whole legend and gives them to the story. The session's display shows the last of them then.
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
