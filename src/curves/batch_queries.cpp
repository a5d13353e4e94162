#include "curves/batch_queries.h"

#include <algorithm>
#include <utility>

namespace evc::curves {
namespace {

using io::Json;
using io::JsonPlace;

constexpr std::size_t kMostInTable = 1000000;

/// What is read instead of `base`: the entry, if it is whole (it has the key that says what it is, or it names a file);
/// else `base` with the members of the entry.
Json laid_over(const Json* base, const Json& entry, const char* says_what) {
  if (base == nullptr || !base->is_object() || !entry.is_object() || entry.contains(says_what)) return entry;
  Json merged = *base;
  for (const auto& [key, value] : entry.items()) merged[key] = value;
  return merged;
}

std::vector<Json> column(const JsonPlace& table, const char* key, const Json* base, const char* says_what) {
  const auto list = table.find(key);
  if (!list) return {base != nullptr ? *base : Json()};
  if (!list->is_array() || list->size() == 0 || list->size() > kMostInTable)
    list->fail("a list of 1 to " + std::to_string(kMostInTable));
  std::vector<Json> entries;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const JsonPlace entry = (*list)[i];
    const bool may_be_named = std::string_view(key) == "train";
    if (!entry.is_object() && !(may_be_named && entry.is_string()))
      entry.fail(may_be_named ? "a train, or the name of a train file" : "a target");
    entries.push_back(laid_over(base, entry.value(), says_what));
  }
  return entries;
}

bool begins_with(const std::string& text, std::string_view begin) {
  return text.compare(0, begin.size(), begin) == 0 && (text.size() == begin.size() || text[begin.size()] == '/');
}

/// The queries of `evc curves` that have no limits by speed.
void refuse_other_queries(const JsonPlace& root) {
  const auto query = root.find("query");
  if (!query || !query->is_object()) return;
  for (const char* key : {"positions_m", "PBD", "LX", "details"})
    if (const auto p = query->find(key); p && !(p->is_array() && p->size() == 0))
      p->fail(std::string(key), "speeds_kmh alone: a batch gives limits by speed");
}

}  // namespace

batch::Target batch_target(const io::CurvesInput& input) {
  batch::Target t;
  t.kind = input.target;
  t.location = t.SvL = input.target_location;
  if (t.kind == sdm::TargetKind::EOA_SvL) t.SvL = input.inputs.authority.SvL;
  if (t.kind == sdm::TargetKind::LOA) t.V_target = input.inputs.authority.V_LOA;
  if (t.kind == sdm::TargetKind::MRSP) {
    const std::size_t step = input.inputs.mrsp.index_at(t.location);
    t.V_target = input.inputs.mrsp.steps[step].value;
    t.due_to_TSR = input.inputs.mrsp_due_to_TSR[step];
  }
  return t;
}

void BatchQuery::take_table(const JsonPlace& root) {
  const auto table = root.find("batch");
  const auto base = [&](const char* key) {
    const auto member = root.value().find(key);
    return member == root.value().end() ? nullptr : &*member;
  };
  const JsonPlace none(table_, file_, where_);
  if (table) {
    table->know_only({"train", "target"});
    table_ = table->value();
  }
  const JsonPlace& given = table ? *table : none;
  trains_ = column(given, "train", base("train"), "brake_model");
  targets_ = column(given, "target", base("target"), "type");
}

io::Result<BatchQuery> BatchQuery::read(std::string_view text, const std::string& file, const std::string& where) {
  auto query = io::guarded([&] {
    BatchQuery q;
    q.file_ = file;
    q.where_ = where;
    q.document_ = io::parse_json(text, file, where);
    const JsonPlace root(q.document_, file, where);
    root.require_schema("evc-curves/1");
    refuse_other_queries(root);
    if (const auto table = root.find("batch"); table && table->find("train")) {
      // Entries that change the train of a file need it here.
      if (const auto train = root.find("train"); train && train->is_string()) {
        Json alone = {{"schema", "evc-curves/1"}, {"train", train->value()}};
        auto in_place = io::curves_document(alone.dump(), file);
        if (!in_place) throw io::ReadError{q.in_table(in_place.error(), 0, 0)};
        q.document_["train"] = (*in_place)["train"];
      }
    }
    q.take_table(JsonPlace(q.document_, file, where));
    q.document_.erase("batch");
    const auto track = q.document_.find("track");
    q.has_mrsp_ = track != q.document_.end() && track->is_object() && track->contains("mrsp");
    return q;
  });
  if (!query) return query;
  for (std::size_t k = 0; k < query->targets(); ++k) {
    const auto input = query->input(0, k);
    if (!input) return tl::unexpected(input.error());
    query->read_targets_.push_back(batch_target(*input));
  }
  return query;
}

io::Result<io::CurvesInput> BatchQuery::input(std::size_t i, std::size_t k) const {
  Json document = document_;
  if (!trains_[i].is_null()) document["train"] = trains_[i];
  if (!targets_[k].is_null()) document["target"] = targets_[k];
  auto input = io::curves_of(document, file_);
  if (!input) return tl::unexpected(in_table(std::move(input.error()), i, k));
  return input;
}

io::Diagnostic BatchQuery::in_table(io::Diagnostic error, std::size_t i, std::size_t k) const {
  if (error.file != file_) return error;
  const std::pair<const char*, std::size_t> columns[] = {{"train", i}, {"target", k}};
  for (const auto& [key, number] : columns) {
    if (!table_.contains(key) || !begins_with(error.where, std::string("/") + key)) continue;
    const std::string rest = error.where.substr(std::string_view(key).size() + 1);
    const Json& entry = table_[key][number];
    // What the entry does not have is that of the document.
    if (rest.empty() || entry.is_string() || entry.contains(Json::json_pointer(rest)))
      error.where = "/batch/" + std::string(key) + "/" + std::to_string(number) + rest;
    break;
  }
  if (!where_.empty()) error.where = error.where.empty() ? where_ : where_ + " " + error.where;
  return error;
}

BatchText documents_of(std::string_view text) {
  BatchText all;
  const auto blank = [](std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; };
  std::size_t number = 0;
  bool lines = false;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string_view line = text.substr(from, end - from);
    from = end + 1;
    ++number;
    if (blank(line)) continue;
    // Of a document of several lines the first one is none.
    if (!lines && !Json::accept(line)) break;
    lines = true;
    all.documents.push_back({line, number, "line " + std::to_string(number)});
  }
  if (!lines) all.documents.push_back({text, 1, ""});
  // One document in one line.
  if (all.documents.size() == 1) all.documents.front().where.clear();
  for (std::size_t i = 0; i < all.documents.size(); ++i) all.documents[i].number = i + 1;
  return all;
}

}  // namespace evc::curves
