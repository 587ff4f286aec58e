#include "host_sim/device_plan/device_plan.hpp"

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr int kMaxStarts = 32;
/// Pages that fill squares of 1024 and 512 texels, and none.
constexpr std::uint32_t kFewerPages[] = {49, 9, 0};
constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;

class DevicePlanner {
public:
    DevicePlanner(const DeviceAsk& ask, const DeviceNeeds& needs, const DeviceStart& start)
        : ask_(ask), needs_(needs), start_(start) {}

    /// Nothing where the memory does not hold all of the shipped device, unless it is the last; then UserError.
    [[nodiscard]] std::optional<DevicePlan> plan(const effects::DeviceSettings& shipped, bool is_last) {
        DraftSource source{shipped, {}, {}};
        for (int n = 0; n < kMaxStarts; ++n) {
            const std::optional<DeviceRoom> room = fit(source, is_last);
            if (!room) return {};
            const effects::DeviceSettings device = draft_device(source, ask_, needs_, *room);
            const StartedDevice started = start_(device);
            if (!started.shortage)
                return DevicePlan{device, std::string(source.shipped.name.view()), given_up(source, *room), larger_};
            raise(*started.shortage, device, source);
        }
        throw UserError("the device still does not start after " + std::to_string(kMaxStarts) +
                        " changes of its budget; please report this");
    }

private:
    [[nodiscard]] std::uint64_t total(const DraftSource& source, const DeviceRoom& room) const {
        return total_bytes(draft_device(source, ask_, needs_, room));
    }
    [[nodiscard]] bool holds(const DraftSource& source, const DeviceRoom& room) const {
        return total(source, room) <= ask_.memory_bytes;
    }

    [[nodiscard]] std::optional<DeviceRoom> fit(DraftSource& source, bool is_last) {
        const std::vector<DeviceRoom> rooms = narrowing(whole_room(source, ask_, needs_));
        for (const DeviceRoom& room : rooms) {
            measure_targets(source, room);
            if (holds(source, room)) return room;
            if (is_last) continue;
            larger_.push_back({std::string(source.shipped.name.view()), total(source, room)});
            return {};
        }
        return with_fewer_slots(source, rooms.back());
    }

    /// From all down to the least, in the order in which things are given up.
    [[nodiscard]] static std::vector<DeviceRoom> narrowing(DeviceRoom room) {
        std::vector<DeviceRoom> rooms = {room};
        const auto give_up_pages = [&](std::uint32_t DeviceRoom::*pages) {
            for (const std::uint32_t fewer : kFewerPages) {
                if (fewer >= room.*pages) continue;
                room.*pages = fewer;
                rooms.push_back(room);
            }
        };
        if (room.is_traced) {
            room.is_traced = false;
            rooms.push_back(room);
        }
        give_up_pages(&DeviceRoom::drape_pages);
        give_up_pages(&DeviceRoom::attribute_pages);
        if (room.has_pictures) {
            room.has_pictures = false;
            rooms.push_back(room);
        }
        return rooms;
    }

    /// The most that the memory holds.
    [[nodiscard]] DeviceRoom with_fewer_slots(const DraftSource& source, DeviceRoom room) const {
        std::uint32_t few = fewest_slots(needs_), many = room.slots;
        room.slots = few;
        if (!holds(source, room)) refuse(total(source, room));
        while (many - few > 1) {
            room.slots = few + (many - few) / 2;
            (holds(source, room) ? few : many) = room.slots;
        }
        room.slots = few;
        return room;
    }

    [[noreturn]] void refuse(std::uint64_t needed) const {
        throw UserError("--memory " + ask_.memory_text + ": " + std::to_string(ask_.memory_bytes) + " bytes are " +
                        std::to_string(needed - ask_.memory_bytes) + " bytes less than the least that a picture of " +
                        std::to_string(ask_.size.width) + "x" + std::to_string(ask_.size.height) + " with the design " +
                        needs_.design + " needs; give --memory " + std::to_string((needed + kMiB - 1) / kMiB) +
                        "M or a smaller --size");
    }

    /// What the design draws off screen does not depend on the slots, so few of them are enough to see it.
    void measure_targets(DraftSource& source, DeviceRoom room) {
        if (source.target_bytes.count(room.has_pictures) != 0) return;
        room.slots = fewest_slots(needs_);
        for (int n = 0; n < kMaxStarts; ++n) {
            const effects::DeviceSettings device = draft_device(source, ask_, needs_, room);
            const StartedDevice started = start_(device);
            if (!started.shortage) {
                source.target_bytes[room.has_pictures] = started.used.find(effects::kRenderTargets)->use.in_use;
                return;
            }
            raise(*started.shortage, device, source);
        }
        throw UserError("--size: pictures of this size do not fit any budget; give a smaller --size");
    }

    static void raise(const base::BudgetShortage& shortage, const effects::DeviceSettings& device, DraftSource& source) {
        const std::string name(shortage.line.view());
        const base::BudgetLine* const line = device.budget.find(name);
        if (line == nullptr || shortage.enough() <= line->bytes)
            throw UserError("the budget line '" + name + "' is refused with " + std::to_string(shortage.enough()) +
                            " bytes, which is what it asks for; please report this");
        source.raised[name] = shortage.enough();
    }

    [[nodiscard]] std::vector<GivenUp> given_up(const DraftSource& source, const DeviceRoom& left) const {
        std::vector<GivenUp> list;
        DeviceRoom room = whole_room(source, ask_, needs_);
        std::uint64_t bytes = total(source, room);
        const auto note = [&](const std::string& what, const std::string& words) {
            const std::uint64_t after = total(source, room);
            if (after == bytes) return;
            list.push_back({what, bytes - after, words + ", which saves " + std::to_string(bytes - after) + " bytes"});
            bytes = after;
        };
        const auto pages = [](std::uint32_t now, std::uint32_t whole) {
            return now == 0 ? "no pages" : std::to_string(now) + " of " + std::to_string(whole) + " pages";
        };
        const DeviceRoom whole = room;
        room.is_traced = left.is_traced;
        note("traced_terrain", "the terrain is drawn by triangles instead of rays");
        room.drape_pages = left.drape_pages;
        note("drape_pages", "the image over the terrain has " + pages(left.drape_pages, whole.drape_pages));
        room.attribute_pages = left.attribute_pages;
        note("attribute_pages", "the baked maps of the terrain have " + pages(left.attribute_pages, whole.attribute_pages));
        room.has_pictures = left.has_pictures;
        note("off_screen_pictures", "there are no pictures off screen, and no effects that need them");
        room.slots = left.slots;
        note("max_chunk_slots",
             "the terrain has " + std::to_string(left.slots) + " of " + std::to_string(whole.slots) + " slots");
        return list;
    }

    const DeviceAsk& ask_;
    const DeviceNeeds& needs_;
    const DeviceStart& start_;
    std::vector<DevicePlan::Larger> larger_;
};

}  // namespace

DevicePlan plan_device(const std::vector<effects::DeviceSettings>& shipped, const DeviceAsk& ask, const DeviceNeeds& needs,
                       const DeviceStart& start) {
    DevicePlanner planner(ask, needs, start);
    for (std::size_t n = 0; n < shipped.size(); ++n)
        if (std::optional<DevicePlan> plan = planner.plan(shipped[n], n + 1 == shipped.size())) return *plan;
    throw UserError("--lane: no shipped device has it; choose es2 or es3");
}

}  // namespace tedavis::host_sim
