#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/json.h"
#include "sweep/spec.h"

// The JSON document of a case: that of `base` with the files in place, and the places that vary in it.
namespace evc::sweep {

/// Where the values of the entries are put.
class Places {
 public:
  Places() = default;
  explicit Places(std::vector<std::vector<std::string>> tokens) : tokens_(std::move(tokens)) {}

  /// Whether an entry varies this member of the document, or something below it.
  bool below(const std::string& member) const;
  /// Puts the values in their places. A member that is missing is made: the reader of the document knows what may be
  /// there.
  void put(io::Json& document, const std::vector<io::Json>& values) const;
  std::size_t size() const { return tokens_.size(); }
  const std::vector<std::string>& operator[](std::size_t i) const { return tokens_[i]; }

 private:
  std::vector<std::vector<std::string>> tokens_;
};

/// The places of the entries of a spec. `left_out`: whether the first token of a place is the member of `base` that the
/// document is, and not one of the document; the last token never is. Throws ReadError for an entry that replaces what
/// another one replaces.
Places places_of(const Spec& spec, const std::function<bool(const std::vector<std::string>&)>& left_out);

/// Reads a document in full; throws ReadError.
using Reader = std::function<void(const io::JsonPlace&)>;

/// Refuses an entry whose pointer leads nowhere in the document: to an element that a list does not have, below a value
/// that has no members, or to a key that the reader does not know. `complete`: members of the document in which every
/// key must be there, because their reader passes over the keys that it does not know. Throws ReadError.
void require_places(const Spec& spec, const Places& places, const io::Json& document, const Reader& reader,
                    const std::vector<std::string>& complete);

/// A member of a case that may be the name of a file, and the folder of the data in which the shipped ones are.
struct File {
  const char* member;
  const char* folder;
};
/// The documents that elements of lists name, by member and name.
struct NamedDocument {
  std::string file;
  io::Json document;
};
using NamedDocuments = std::map<std::pair<std::string, std::string>, NamedDocument>;
/// Those of the lists in the places of whole `files`; each name counts as in `base`. Throws ReadError.
NamedDocuments named_documents(const Spec& spec, const Places& places, std::span<const File> files);
/// Puts a document that was read where its name is, if the member is a name.
void put_document(io::Json& document, const std::string& member, const NamedDocuments& named);

/// How the values of an entry are judged before anything is computed.
enum class Judged : std::uint8_t {
  /// By their form: no case can have a value of another kind than its reader takes (a number instead of a name), or one
  /// with keys that the reader does not know. One that is out of range is a case that cannot be.
  form,
  /// In full: one that is out of range too.
  whole,
};
/// Reads the member of a case, that is the first token of a place, and whatever else; throws ReadError.
using MemberReader = std::function<void(const std::string& member, const io::JsonPlace& document)>;

/// Refuses an entry with a value that its place cannot have. `document`: that of `base`; `judged`: by member.
/// Throws ReadError with the place in the spec and what is written there, or with that in a file that a list names.
void require_values(const Spec& spec, const Places& places, const io::Json& document, const NamedDocuments& named,
                    const MemberReader& reader, const std::function<Judged(const std::string& member)>& judged);

/// "PLACE: found X, expected Y": the reason of a case that cannot be.
std::string reason_of(const io::Diagnostic& diagnostic);

/// The names that the spec asks for, or all of them. Throws ReadError for one that does not exist.
std::vector<std::string> chosen(const Spec& spec, const std::vector<std::string>& all,
                                const std::function<bool(const std::string&)>& exists);

}  // namespace evc::sweep
