#include "render_core/raytrace/stream/picture_tasks.hpp"

namespace tedavis::raytrace {
namespace {

/// Adds stages from the last to the first, until one is refused.
class StageChain {
public:
    explicit StageChain(TaskNetwork& network) : network_(network) {}

    TaskId add(Task stage, TaskId next) {
        if (stage.run == nullptr || !fault_.empty()) return kNoTask;
        stage.next = next;
        const TaskNetwork::Answer answer = network_.add(stage);
        if (answer) return answer.value();
        fault_ = answer.error();
        return kNoTask;
    }
    [[nodiscard]] const base::FaultText& fault() const { return fault_; }

private:
    TaskNetwork& network_;
    base::FaultText fault_;
};

}  // namespace

base::Result<PictureTasks, base::FaultText> add_picture_tasks(TaskNetwork& network, const PictureStages& stages,
                                                              RangeSteps& steps) {
    if (stages.primary.run == nullptr || stages.shade.run == nullptr || stages.set_pixel.run == nullptr)
        return base::fail(base::FaultText("a picture needs the stages primary, shade and set pixel; give each a function"));
    if (stages.primary.arguments != kRangeArguments)
        return base::fail(base::FaultText("the stage primary takes two words, the first tile and the end; state 2 arguments"));
    StageChain chain(network);
    PictureTasks tasks;
    tasks.set_pixel = chain.add(stages.set_pixel, kNoTask);
    tasks.shade = chain.add(stages.shade, tasks.set_pixel);
    tasks.surface = chain.add(stages.surface, tasks.shade);
    const TaskId met = tasks.surface == kNoTask ? tasks.shade : tasks.surface;
    tasks.trace = chain.add(stages.trace, met);
    tasks.primary = chain.add(stages.primary, met);
    tasks.tiles = chain.add(make_range_task("tiles", steps, tasks.primary), tasks.primary);
    if (!chain.fault().empty()) return base::fail(chain.fault());
    return tasks;
}

bool begin_picture(TokenStream& stream, const PictureTasks& tasks, std::uint32_t tiles) {
    const Token program[] = {literal(0), literal(tiles), call(tasks.tiles)};
    return stream.try_append(program);
}

}  // namespace tedavis::raytrace
