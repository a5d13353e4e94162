#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "batch/limits.h"
#include "io/curves_file.h"

// The input of `evc curves --batch`: queries (evc-curves/1), each alone or with a table of trains and targets.
namespace evc::curves {

/// A query with its table: every train with every target. Without a table there is one of each.
class BatchQuery {
 public:
  /// Reads a document. `where` is its place in the file ("line 7"), or empty. Everything that does not depend on one
  /// train or target is checked, and every target with the first train.
  static io::Result<BatchQuery> read(std::string_view text, const std::string& file, const std::string& where);

  std::size_t trains() const { return trains_.size(); }
  std::size_t targets() const { return targets_.size(); }
  /// Target `k` as the kernels take it.
  const batch::Target& target(std::size_t k) const { return read_targets_[k]; }
  /// Whether a target may be wrong for one train and right for another: a restriction has to be slower than the MRSP,
  /// which is the maximum train speed where the query has none.
  bool targets_depend_on_trains() const { return !has_mrsp_; }
  /// Train `i` with target `k`, as `evc curves` reads it.
  io::Result<io::CurvesInput> input(std::size_t i, std::size_t k) const;

 private:
  BatchQuery() = default;
  void take_table(const io::JsonPlace& root);
  io::Diagnostic in_table(io::Diagnostic error, std::size_t i, std::size_t k) const;

  std::string file_, where_;
  io::Json document_;                       // without the table
  std::vector<io::Json> trains_, targets_;  // read instead of those of the document
  io::Json table_ = io::Json::object();     // as given
  std::vector<batch::Target> read_targets_;
  bool has_mrsp_ = false;
};

/// The target of a query.
batch::Target batch_target(const io::CurvesInput& input);

/// The documents in a text: one a line, or one in all.
struct BatchText {
  struct Document {
    std::string_view text;
    std::size_t number = 1;  ///< from 1
    std::string where;       ///< "line 7"; empty for one document in all
  };
  std::vector<Document> documents;
};
BatchText documents_of(std::string_view text);

}  // namespace evc::curves
