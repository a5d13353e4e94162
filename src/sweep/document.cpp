#include "sweep/document.h"

#include <algorithm>
#include <utility>

#include "io/json_pointer.h"
#include "io/named_document.h"

namespace evc::sweep {
namespace {

using io::index_of;
using io::Json;
using io::JsonPlace;
using io::pointer_of;

[[noreturn]] void leads_nowhere(const Spec& spec, std::size_t entry, const std::string& expected) {
  throw io::ReadError{
      {spec.file, "/vary/" + std::to_string(entry) + "/at", spec.vary[entry].at + ", which leads nowhere", expected}};
}

std::string keys_of(const Json& object) {
  std::string list;
  for (const auto& [key, value] : object.items()) list += (list.empty() ? "" : ", ") + key;
  return list.empty() ? "another place" : "one of " + list;
}

/// The way through the document as it is. True when the last token is there.
bool leads_to_a_value(const Spec& spec, const Places& places, std::size_t entry, const Json& document,
                      const std::vector<std::string>& complete) {
  const auto& tokens = places[entry];
  const Json* at = &document;
  const bool all_there = std::find(complete.begin(), complete.end(), tokens.front()) != complete.end();
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string here = i == 0 ? "the case" : pointer_of(tokens, i);
    if (at->is_array()) {
      const std::size_t index = index_of(tokens[i]);
      if (index >= at->size())
        leads_nowhere(spec, entry, "an index of " + here + ", which has " + std::to_string(at->size()) + " elements");
      at = &(*at)[index];
    } else if (at->is_object()) {
      const auto member = at->find(tokens[i]);
      if (member == at->end()) {
        if (i == 0 || all_there) leads_nowhere(spec, entry, keys_of(*at) + " in " + here);
        return false;
      }
      at = &*member;
    } else {
      leads_nowhere(spec, entry, "a place: " + here + " has no members");
    }
  }
  return true;
}

}  // namespace

bool Places::below(const std::string& member) const {
  return std::any_of(tokens_.begin(), tokens_.end(), [&](const auto& tokens) { return tokens.front() == member; });
}

void Places::put(Json& document, const std::vector<Json>& values) const {
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    Json* at = &document;
    for (const std::string& token : tokens_[i]) at = at->is_array() ? &at->at(index_of(token)) : &(*at)[token];
    *at = values[i];
  }
}

Places places_of(const Spec& spec, const std::function<bool(const std::vector<std::string>&)>& left_out) {
  std::vector<std::vector<std::string>> places;
  for (const Entry& entry : spec.vary) {
    std::vector<std::string> tokens = io::tokens_of(entry.at);
    if (tokens.size() > 1 && left_out(tokens)) tokens.erase(tokens.begin());
    for (const auto& other : places) {
      const auto [mine, theirs] = std::mismatch(tokens.begin(), tokens.end(), other.begin(), other.end());
      if (mine == tokens.end() || theirs == other.end())
        throw io::ReadError{{spec.file, "/vary/" + std::to_string(entry.place) + "/at", "\"" + entry.at + "\"",
                             "a place that no other entry replaces"}};
    }
    places.push_back(std::move(tokens));
  }
  return Places(std::move(places));
}

void require_places(const Spec& spec, const Places& places, const Json& document, const Reader& reader,
                    const std::vector<std::string>& complete) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (leads_to_a_value(spec, places, i, document, complete)) continue;
    // The reader decides: it knows the keys that may be absent.
    Json with = document;
    Json* at = &with;
    for (const std::string& token : places[i]) at = at->is_array() ? &at->at(index_of(token)) : &(*at)[token];
    const Entry& entry = spec.vary[i];
    *at = entry.how == Entry::How::list ? entry.list.front() : Json(1);
    try {
      reader(JsonPlace(with, spec.file));
    } catch (const io::ReadError& e) {
      const std::string& where = e.diagnostic.where;
      const std::string whole = pointer_of(places[i], places[i].size());
      if (e.diagnostic.found == "an unknown key" && whole.compare(0, where.size(), where) == 0)
        leads_nowhere(spec, i, e.diagnostic.expected);
    }
  }
}

void require_values(const Spec& spec, const Places& places, const std::string& member, const Reader& reader) {
  const Json whole = io::parse_json(spec.text, spec.file);
  const JsonPlace root(whole, spec.file);
  // The error of the reader for a value that the spec does not have itself, at the place that gives it.
  const auto require = [&](const Json& value, const JsonPlace& place) {
    try {
      reader(JsonPlace(value, spec.file));
    } catch (const io::ReadError& e) {
      place.fail(e.diagnostic.found + " among the values", e.diagnostic.expected);
    }
  };
  for (std::size_t e = 0; e < places.size(); ++e) {
    if (places[e].size() != 1 || places[e].front() != member) continue;
    const Entry& entry = spec.vary[e];
    const JsonPlace place = root["vary"][entry.place];
    if (const auto list = place.find("list"))
      for (std::size_t i = 0; i < list->size(); ++i) reader((*list)[i]);
    else if (const auto range = place.find("range"))
      for (const Json& value : entry.list) require(value, *range);
    else if (entry.is_drawn())
      require(entry.first + 0.5, place[entry.how == Entry::How::uniform ? "uniform" : "normal"]);
  }
}

NamedDocuments named_documents(const Spec& spec, const Places& places, std::span<const File> files) {
  const Json whole = io::parse_json(spec.text, spec.file);
  const JsonPlace root(whole, spec.file);
  NamedDocuments documents;
  for (std::size_t e = 0; e < places.size(); ++e)
    for (const auto& [member, folder] : files) {
      if (places[e].size() != 1 || places[e].front() != member) continue;
      const Entry& entry = spec.vary[e];
      for (std::size_t i = 0; i < entry.list.size(); ++i) {
        if (!entry.list[i].is_string()) continue;
        const io::Named named = io::read_named(root["vary"][entry.place]["list"][i], folder);
        documents[{member, entry.list[i].get<std::string>()}] = {named.file, io::parse_json(named.text, named.file)};
      }
    }
  return documents;
}

void put_named(Json& document, const std::string& member, const NamedDocuments& named) {
  Json& part = document[member];
  if (!part.is_string()) return;
  if (const auto one = named.find({member, part.get<std::string>()}); one != named.end())
    part = Json(one->second.document);
}

std::string reason_of(const io::Diagnostic& d) {
  const std::string text = (d.where.empty() ? "" : d.where + ": ") + "found " + d.found + ", expected " + d.expected;
  return io::printable(text, 1000);
}

std::vector<std::string> chosen(const Spec& spec, const std::vector<std::string>& all,
                                const std::function<bool(const std::string&)>& exists) {
  if (spec.measure.empty()) return all;
  for (std::size_t i = 0; i < spec.measure.size(); ++i) {
    if (exists(spec.measure[i])) continue;
    std::string list;
    for (const std::string& name : all) list += (list.empty() ? "" : ", ") + name;
    throw io::ReadError{{spec.file, "/measure/" + std::to_string(i), "\"" + spec.measure[i] + "\"", "one of " + list}};
  }
  return spec.measure;
}

}  // namespace evc::sweep
