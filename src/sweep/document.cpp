#include "sweep/document.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
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

/// Whether a reader that expected this takes no value of the kind of this one, whatever it is. The words are those of
/// JsonPlace.
bool is_of_another_kind(const Json& value, const std::string& expected) {
  const auto begins = [&](const char* words) { return expected.rfind(words, 0) == 0; };
  if (begins("a number")) return !value.is_number();
  if (begins("an integer")) return !value.is_number_integer();
  if (begins("true or false")) return !value.is_boolean();
  if (begins("a string") || begins("one of \"") || begins("hexadecimal digits")) return !value.is_string();
  if (begins("an array")) return !value.is_array();
  if (begins("an object")) return !value.is_object();
  return false;
}

/// Whether an error of a document is one of its form, not of the size of a number in it.
bool is_of_form(const io::Diagnostic& error, const Json& document) {
  if (error.found == "an unknown key" || error.found.rfind("no key ", 0) == 0) return true;
  const Json* at = &document;
  for (const std::string& token : io::tokens_of(error.where == "/" ? "" : error.where)) {
    if (token == "schema") return true;
    if (at->is_array() && index_of(token) < at->size())
      at = &(*at)[index_of(token)];
    else if (at->is_object() && at->contains(token))
      at = &(*at)[token];
    else
      return false;
  }
  return is_of_another_kind(*at, error.expected);
}

/// Values of an entry that stand for all of it, by their index in its list: of numbers, texts and flags that are
/// judged by their form, one of each kind; of names of files each.
std::vector<std::pair<std::size_t, Json>> values_to_judge(const Entry& entry, Judged judged, bool may_be_files) {
  if (entry.how == Entry::How::count) return {{0, Json(1)}, {0, Json(static_cast<std::int64_t>(entry.count))}};
  if (entry.is_drawn()) return {{0, Json(entry.first + 0.5)}};
  std::vector<std::pair<std::size_t, Json>> values;
  std::set<Json::value_t> seen;
  for (std::size_t i = 0; i < entry.list.size(); ++i) {
    const Json& value = entry.list[i];
    const bool each = judged == Judged::whole || value.is_structured() || (may_be_files && value.is_string());
    if (seen.insert(value.type()).second || each) values.emplace_back(i, value);
  }
  return values;
}

/// What is written in the spec for numbers that an entry makes.
std::string as_written(const Entry& entry, const Json& values) {
  const std::string text = values.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (entry.how == Entry::How::count) return text + ", the numbers from 1 on";
  if (entry.is_drawn()) return text + ", numbers with a fraction";
  return text + (entry.list.front().is_number_integer() ? ", numbers" : ", numbers with a fraction");
}

/// An error of a reader that is one of the value at `where`: the place of it in the value, "" for the whole of it. None
/// where the reader stopped before it came to the value.
std::optional<std::string> place_in_value(const io::Diagnostic& error, const std::string& where) {
  if (error.where.compare(0, where.size(), where) != 0) return std::nullopt;
  const std::string rest = error.where.substr(where.size());
  return rest.empty() || rest.front() == '/' ? std::optional(rest) : std::nullopt;
}

/// Judges one value of an entry after the other.
class Judge {
 public:
  Judge(const Spec& spec, const NamedDocuments& named, const MemberReader& reader)
      : spec_(spec), named_(named), reader_(reader), text_(io::parse_json(spec.text, spec.file)) {}

  /// Throws what is wrong with the values of an entry in its place in one of the documents: the first that the reader
  /// can read up to there.
  void judge(const Entry& entry, const std::vector<std::string>& tokens, Judged how,
             std::array<Json, 2>& documents) const {
    for (const auto& [i, value] : values_to_judge(entry, how, tokens.size() == 1))
      for (Json& document : documents)
        if (was_read(entry, i, value, tokens, how, document)) break;
  }

  /// Throws what is wrong in the form of the member itself, beside the places of the entries: so are all cases.
  void judge_base(const Places& places, const std::string& member, const Json& document) const {
    try {
      reader_(member, JsonPlace(document, spec_.file));
    } catch (const io::ReadError& e) {
      if (!is_of_form(e.diagnostic, document)) return;
      const std::string where = e.diagnostic.where + '/';
      for (std::size_t i = 0; i < places.size(); ++i) {
        const std::string varied = pointer_of(places[i], places[i].size()) + '/';
        if (where.compare(0, varied.size(), varied) == 0 || varied.compare(0, where.size(), where) == 0) return;
      }
      throw io::ReadError{{spec_.file, place_in_base(e.diagnostic.where), e.diagnostic.found, e.diagnostic.expected}};
    }
  }

 private:
  /// A place of the document as one of `base`: "/base/odometer/x"; in a file "/base/train /length_m".
  std::string place_in_base(const std::string& where) const {
    if (spec_.kind != Kind::run) return (spec_.kind == Kind::curves ? "/base/query " : "/base/inputs ") + where;
    const std::string member = io::tokens_of(where).front();
    const auto given = spec_.base.find(member);
    const bool is_file = given != spec_.base.end() && given->is_string();
    return is_file ? "/base/" + member + ' ' + where.substr(member.size() + 1) : "/base" + where;
  }

  bool was_read(const Entry& entry, std::size_t i, const Json& value, const std::vector<std::string>& tokens,
                Judged how, Json document) const {
    const std::string& member = tokens.front();
    Json* at = &document;
    for (const std::string& token : tokens) at = at->is_array() ? &at->at(index_of(token)) : &(*at)[token];
    *at = value;
    const bool may_be_file = tokens.size() == 1 && value.is_string();
    const auto file = may_be_file ? named_.find({member, value.get<std::string>()}) : named_.end();
    if (file != named_.end()) *at = Json(file->second.document);
    try {
      reader_(member, JsonPlace(document, spec_.file));
      return true;
    } catch (const io::ReadError& e) {
      const auto rest = place_in_value(e.diagnostic, pointer_of(tokens, tokens.size()));
      if (rest && (how == Judged::whole || is_of_form(e.diagnostic, document)))
        refuse(entry, i, *rest, e.diagnostic, file != named_.end() ? file->second.file : "");
      return rest.has_value();
    }
  }

  /// `rest`: the place in the value; `file`: that which the value names, or "".
  [[noreturn]] void refuse(const Entry& entry, std::size_t i, const std::string& rest, const io::Diagnostic& error,
                           const std::string& file) const {
    if (!file.empty()) throw io::ReadError{{file, rest.empty() ? "/" : rest, error.found, error.expected}};
    const JsonPlace in_spec = JsonPlace(text_, spec_.file)["vary"][entry.place];
    if (in_spec.find("list")) {
      const std::string place = "/vary/" + std::to_string(entry.place) + "/list/" + std::to_string(i);
      throw io::ReadError{{spec_.file, place + rest, error.found, error.expected}};
    }
    for (const char* how : {"range", "uniform", "normal", "count"})
      if (const auto values = in_spec.find(how)) values->fail(as_written(entry, values->value()), error.expected);
    throw io::ReadError{error};  // read_spec wants one of them
  }

  const Spec& spec_;
  const NamedDocuments& named_;
  const MemberReader& reader_;
  Json text_;
};

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
      if (whole.compare(0, where.size(), where) != 0) continue;
      if (e.diagnostic.found == "an unknown key") leads_nowhere(spec, i, e.diagnostic.expected);
      // The members below a number or a text were made.
      if (where.size() < whole.size() && is_of_another_kind(Json::object(), e.diagnostic.expected))
        leads_nowhere(spec, i, "a place: " + where + " has no members");
    }
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

void put_document(Json& document, const std::string& member, const NamedDocuments& named) {
  Json& part = document[member];
  if (!part.is_string()) return;
  if (const auto one = named.find({member, part.get<std::string>()}); one != named.end())
    part = Json(one->second.document);
}

void require_values(const Spec& spec, const Places& places, const Json& document, const NamedDocuments& named,
                    const MemberReader& reader, const std::function<Judged(const std::string& member)>& judged) {
  // `base` may lack what an entry gives: so with the first values of all entries too.
  std::array<Json, 2> documents{document, document};
  std::vector<Json> first;
  for (const Entry& entry : spec.vary)
    first.push_back(!entry.list.empty() ? entry.list.front() : entry.is_drawn() ? Json(entry.first) : Json(1));
  places.put(documents[1], first);
  for (const auto& [key, one] : named) put_document(documents[1], key.first, named);
  const Judge judge(spec, named, reader);
  for (std::size_t e = 0; e < places.size(); ++e)
    judge.judge(spec.vary[e], places[e], judged(places[e].front()), documents);
  for (std::size_t e = 0; e < places.size(); ++e) judge.judge_base(places, places[e].front(), documents[1]);
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
