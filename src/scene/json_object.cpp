#include "scene/json_object.hpp"

#include "scene/limits.hpp"

#include <fmt/format.h>

namespace tessera::scene {
namespace {

using json = nlohmann::json;

/// A value as an error shows it; containers by type only, since they may be large.
std::string shown(const json& value) {
    if (value.is_string()) return in_quotes(value.get_ref<const std::string&>());
    if (value.is_structured()) return fmt::format("an {}", value.type_name());
    return value.dump();
}

/// Reads the text without keeping anything, within the limits. A pass of its own, because the library's parser with a
/// callback takes quadratic time on long arrays.
class LimitCheck : public nlohmann::json_sax<json> {
public:
    explicit LimitCheck(const Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    bool null() override { return count(); }
    bool boolean(bool) override { return count(); }
    bool number_integer(number_integer_t) override { return count(); }
    bool number_unsigned(number_unsigned_t) override { return count(); }
    bool number_float(number_float_t, const string_t&) override { return count(); }
    bool string(string_t&) override { return count(); }
    bool binary(binary_t&) override { return count(); }
    bool key(string_t&) override { return count(); }
    bool start_object(std::size_t) override { return enter(); }
    bool start_array(std::size_t) override { return enter(); }
    bool end_object() override { return leave(); }
    bool end_array() override { return leave(); }
    bool parse_error(std::size_t, const std::string&, const json::exception& error) override {
        // The library's own words begin with "[json.exception.parse_error.101] ".
        const std::string_view what = error.what();
        diagnostics_.refuse("the JSON text", "cannot be parsed: " + in_quotes(what.substr(what.find(']') + 2), 200));
    }

private:
    bool count() {
        if (++values_ > max_json_values) {
            diagnostics_.refuse("the JSON text", fmt::format("holds more than {} values", max_json_values));
        }
        return true;
    }
    bool enter() {
        if (++depth_ > max_json_depth) {
            diagnostics_.refuse("the JSON text", fmt::format("is nested deeper than {} levels", max_json_depth));
        }
        return count();
    }
    bool leave() {
        --depth_;
        return true;
    }

    const Diagnostics& diagnostics_;
    std::uint64_t values_ = 0;
    int depth_ = 0;
};

}  // namespace

json parse_json(std::string_view text, const Diagnostics& diagnostics) {
    LimitCheck check(diagnostics);
    json::sax_parse(text.begin(), text.end(), &check);
    return json::parse(text.begin(), text.end());
}

JsonObject::JsonObject(const json& from, json& to, std::string place, const Diagnostics& diagnostics)
    : from_(from), to_(to), place_(std::move(place)), diagnostics_(diagnostics) {
    if (!from_.is_object()) {
        diagnostics_.refuse(place_.empty() ? "the document" : place_, "is " + shown(from_) + ", but must be an object");
    }
    to_ = json::object();
}

std::string JsonObject::path(const char* key) const {
    return place_.empty() ? key : place_ + "." + key;
}

void JsonObject::refuse(const char* key, const std::string& reason) const {
    diagnostics_.refuse(path(key), reason);
}

const json* JsonObject::find(const char* key, Need need) const {
    const auto it = from_.find(key);
    if (it != from_.end()) return &*it;
    if (need == Need::required) refuse(key, "is missing");
    return nullptr;
}

const json* JsonObject::find_array(const char* key, Need need) const {
    const json* value = find(key, need);
    if (value == nullptr) return nullptr;
    if (!value->is_array()) refuse(key, "is " + shown(*value) + ", but must be an array");
    if (value->size() > max_elements) {
        refuse(key, fmt::format("has {} entries, more than the {} supported", value->size(), max_elements));
    }
    return value;
}

std::size_t JsonObject::size_of(const char* key) const {
    const json* value = find_array(key, Need::optional);
    return value == nullptr ? 0 : value->size();
}

std::optional<std::int64_t> JsonObject::integer(const char* key, std::int64_t least, std::int64_t most, Need need) {
    const json* value = find(key, need);
    if (value == nullptr) return std::nullopt;
    // An unsigned number above the int64 range must not be read as a negative one.
    const bool fits = value->is_number_unsigned() ? value->get<std::uint64_t>() <= static_cast<std::uint64_t>(most)
                                                  : value->is_number_integer() && value->get<std::int64_t>() <= most;
    if (!fits || value->get<std::int64_t>() < least) {
        refuse(key, fmt::format("is {}, but must be an integer from {} to {}", shown(*value), least, most));
    }
    to_[key] = *value;
    return value->get<std::int64_t>();
}

std::int64_t JsonObject::checked_index(const json& value, std::size_t size, const std::string& element) const {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= size) {
        const std::string expected =
            size == 0 ? "there is nothing to refer to" : fmt::format("must be an index below {}", size);
        diagnostics_.refuse(element, fmt::format("is {}, but {}", shown(value), expected));
    }
    return value.get<std::int64_t>();
}

std::optional<std::int64_t> JsonObject::reference(const char* key, std::size_t size, Need need) {
    const json* value = find(key, need);
    if (value == nullptr) return std::nullopt;
    const std::int64_t index = checked_index(*value, size, path(key));
    to_[key] = index;
    return index;
}

std::vector<std::int64_t> JsonObject::references(const char* key, std::size_t size, Need need) {
    std::vector<std::int64_t> indices;
    const json* value = find_array(key, need);
    if (value == nullptr) return indices;
    for (const json& entry : *value) {
        indices.push_back(checked_index(entry, size, fmt::format("{}[{}]", path(key), indices.size())));
    }
    to_[key] = indices;
    return indices;
}

void JsonObject::copy_references(std::size_t size) {
    for (const auto& [name, value] : from_.items()) {
        to_[name] = checked_index(value, size, place_ + "." + name);
    }
}

void JsonObject::reference_map(const char* key, std::size_t size, Need need) {
    object(
        key, [&](JsonObject& map) { map.copy_references(size); }, need);
}

void JsonObject::reference_maps(const char* key, std::size_t size) {
    objects(key, [&](JsonObject& map) { map.copy_references(size); });
}

std::optional<double> JsonObject::number(const char* key) {
    const json* value = find(key, Need::optional);
    if (value == nullptr) return std::nullopt;
    if (!value->is_number()) refuse(key, "is " + shown(*value) + ", but must be a number");
    to_[key] = value->get<double>();
    return value->get<double>();
}

void JsonObject::numbers(const char* key, std::size_t count) {
    const json* value = find_array(key, Need::optional);
    if (value == nullptr) return;
    if (count != 0 && value->size() != count) {
        refuse(key, fmt::format("has {} entries, but must have {}", value->size(), count));
    }
    std::vector<double> numbers;
    for (const json& entry : *value) {
        if (!entry.is_number()) refuse(key, "holds " + shown(entry) + ", but must hold numbers only");
        numbers.push_back(entry.get<double>());
    }
    to_[key] = numbers;
}

void JsonObject::boolean(const char* key) {
    const json* value = find(key, Need::optional);
    if (value == nullptr) return;
    if (!value->is_boolean()) refuse(key, "is " + shown(*value) + ", but must be true or false");
    to_[key] = *value;
}

void JsonObject::extra_number(const char* key) {
    const auto extras = from_.find("extras");
    if (extras == from_.end() || !extras->is_object()) return;
    const auto value = extras->find(key);
    if (value != extras->end() && value->is_number()) to_["extras"][key] = *value;
}

std::optional<std::string> JsonObject::string(const char* key, Need need) {
    const json* value = find(key, need);
    if (value == nullptr) return std::nullopt;
    if (!value->is_string()) refuse(key, "is " + shown(*value) + ", but must be a string");
    to_[key] = *value;
    return value->get<std::string>();
}

std::vector<std::string> JsonObject::strings(const char* key) {
    std::vector<std::string> out;
    const json* value = find_array(key, Need::optional);
    if (value == nullptr) return out;
    for (const json& entry : *value) {
        if (!entry.is_string()) refuse(key, "holds " + shown(entry) + ", but must hold strings only");
        out.push_back(entry.get<std::string>());
    }
    return out;
}

void JsonObject::object(const char* key, const Reader& read, Need need) {
    const json* value = find(key, need);
    if (value == nullptr) return;
    JsonObject member(*value, to_[key], path(key), diagnostics_);
    read(member);
}

std::size_t JsonObject::objects(const char* key, const Reader& read) {
    const json* value = find_array(key, Need::optional);
    if (value == nullptr) return 0;
    json copy = json::array();
    for (std::size_t i = 0; i < value->size(); ++i) {
        json& entry = copy.emplace_back();
        JsonObject member((*value)[i], entry, fmt::format("{}[{}]", path(key), i), diagnostics_);
        read(member);
    }
    to_[key] = std::move(copy);
    return value->size();
}

}  // namespace tessera::scene
