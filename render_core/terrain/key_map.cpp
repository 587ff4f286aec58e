#include "render_core/terrain/key_map.hpp"

namespace tedavis::terrain {
namespace {

std::uint32_t places_for(std::uint32_t max_entries) {
    std::uint32_t places = 2;
    while (places < 2 * std::uint64_t{max_entries} && places < (1u << 31)) places *= 2;
    return places;
}

}  // namespace

std::uint64_t KeyMap::bytes_needed(std::uint32_t max_entries) {
    return std::uint64_t{places_for(max_entries)} * sizeof(Place) + alignof(Place);
}

bool KeyMap::start(base::Arena& arena, std::uint32_t max_entries) {
    const std::uint32_t places = places_for(max_entries);
    places_ = arena.allocate_array<Place>(places);
    mask_ = places - 1;
    max_entries_ = max_entries;
    size_ = 0;
    return !places_.empty();
}

/// Fibonacci hashing: the high bits of the product depend on all bits of the key.
std::size_t KeyMap::home(std::uint64_t key) const { return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15u) >> 32) & mask_; }

std::uint32_t KeyMap::find(std::uint64_t key) const {
    for (std::size_t n = home(key);; n = (n + 1) & mask_) {
        if (places_[n].key == key) return places_[n].value;
        if (places_[n].key == 0) return kNone;
    }
}

void KeyMap::change(std::uint64_t key, std::uint32_t value) {
    std::size_t n = home(key);
    while (places_[n].key != key) {
        TEDAVIS_CHECK(places_[n].key != 0);
        n = (n + 1) & mask_;
    }
    places_[n].value = value;
}

bool KeyMap::insert(std::uint64_t key, std::uint32_t value) {
    TEDAVIS_CHECK(key != 0);
    if (size_ == max_entries_) return false;
    std::size_t n = home(key);
    while (places_[n].key != 0) n = (n + 1) & mask_;
    places_[n] = {key, value};
    ++size_;
    return true;
}

void KeyMap::erase(std::uint64_t key) {
    std::size_t hole = home(key);
    while (places_[hole].key != key) {
        if (places_[hole].key == 0) return;
        hole = (hole + 1) & mask_;
    }
    // What a search would no longer reach across the hole moves into it.
    for (std::size_t n = (hole + 1) & mask_; places_[n].key != 0; n = (n + 1) & mask_) {
        if (((n - home(places_[n].key)) & mask_) < ((n - hole) & mask_)) continue;
        places_[hole] = places_[n];
        hole = n;
    }
    places_[hole] = {};
    --size_;
}

void KeyMap::clear() {
    for (Place& place : places_) place = {};
    size_ = 0;
}

}  // namespace tedavis::terrain
