// Checked copying of JSON: a value reaches the copy only after its type and range were looked at.
#pragma once

#include "scene/diagnostics.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tessera::scene {

/// Parses `text` within the limits of depth and number of values; throws Error(usage) where it is not JSON.
nlohmann::json parse_json(std::string_view text, const Diagnostics& diagnostics);

enum class Need { optional, required };

/// A JSON object that is read member by member. Each reader checks the member, copies it to the object's copy and
/// returns it; a member that nothing reads is not in the copy. Anything wrong throws Error(usage) with the member's
/// path, such as `accessors[3].count`.
class JsonObject {
public:
    using json = nlohmann::json;
    static constexpr std::int64_t int_max = std::numeric_limits<std::int32_t>::max();

    /// `place` is the path of this object, empty for the document.
    JsonObject(const json& from, json& to, std::string place, const Diagnostics& diagnostics);

    const std::string& place() const { return place_; }
    bool has(const char* key) const { return from_.contains(key); }
    [[noreturn]] void refuse(const char* key, const std::string& reason) const;

    /// Integers are integers in JSON too (no fraction, no exponent), as glTF demands.
    std::optional<std::int64_t> integer(const char* key, std::int64_t least, std::int64_t most,
                                        Need need = Need::optional);
    /// An index below `size`.
    std::optional<std::int64_t> reference(const char* key, std::size_t size, Need need = Need::optional);
    std::vector<std::int64_t> references(const char* key, std::size_t size, Need need = Need::optional);
    /// An object of indices (the attributes of a primitive).
    void reference_map(const char* key, std::size_t size, Need need);
    /// An array of such objects (the morph targets of a primitive).
    void reference_maps(const char* key, std::size_t size);
    std::optional<double> number(const char* key);
    /// `count` numbers, or any number of them if it is 0.
    void numbers(const char* key, std::size_t count);
    void boolean(const char* key);
    /// A number in the application's own `extras`, which may hold anything: what is no number is passed over.
    void extra_number(const char* key);
    std::optional<std::string> string(const char* key, Need need = Need::optional);
    std::vector<std::string> strings(const char* key);

    using Reader = std::function<void(JsonObject&)>;
    void object(const char* key, const Reader& read, Need need = Need::optional);
    /// An array of objects, each read in turn. Returns how many there are.
    std::size_t objects(const char* key, const Reader& read);
    /// How many entries an array has, 0 if it is absent. Refuses other types, and more than max_elements.
    std::size_t size_of(const char* key) const;

private:
    const json* find(const char* key, Need need) const;
    const json* find_array(const char* key, Need need) const;
    std::string path(const char* key) const;
    void copy_references(std::size_t size);
    std::int64_t checked_index(const json& value, std::size_t size, const std::string& element) const;

    const json& from_;
    json& to_;
    std::string place_;
    const Diagnostics& diagnostics_;
};

}  // namespace tessera::scene
