#pragma once
// SPDX-License-Identifier: MIT
// The content of a picture of a behaviour, before any format: boxes in layers, and arrows, each once. It holds texts
// and places only, so that a format has nothing to look up. If a group requests everything in one way, the arrow leaves
// from the group, otherwise from the requesting provider or pack.

#include "compiler/emit/graph/picture/picture_options.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"
#include "dsl/source/source_file.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

/// A tooltip: the text, and the place of the declaration.
struct PictureText {
  std::string words;
  std::string file;       ///< as findings name it; empty: nowhere
  std::uint32_t line = 0; ///< from 1
  bool operator==(const PictureText&) const = default;
};

/// `when Stability == standing`.
struct PictureLine {
  enum class Kind { when, stay, causing, sets, runs, outer, wrong, doubtful };
  Kind kind = Kind::when;
  std::string key; ///< as it is written: when, stay, causing, sets, on, every, start, stop, extern
  std::string text;
  bool operator==(const PictureLine&) const = default;
};

struct PicturePack {
  std::string name;
  PictureText about;
};

struct PictureRow {
  std::string name; ///< empty if the group has the provider's keys itself
  std::vector<PictureLine> lines;
  std::vector<PicturePack> packs; ///< only where there is a choice between several
  bool is_active = false;         ///< at the moment that is shown
  PictureText about;
};

struct PictureMember {
  std::string name;
  PictureText about;
  std::optional<Moment::Standing> now{};  ///< of a folded box: nothing: no moment is shown
  std::vector<Moment::Standing> frames{}; ///< likewise, as in PictureBox
};

/// The name of the box of all groups without a layer, where each layer is a box.
inline constexpr std::string_view no_layer = "no layer";

struct PictureBox {
  enum class Kind {
    group,
    alike,   ///< several groups with the same requesters and the same kinds of requests
    folded,  ///< a module or a layer as a whole
    missing, ///< a name that no group has
  };
  Kind kind = Kind::group;
  std::string name; ///< no two boxes have the same
  std::vector<GroupId> groups;
  std::vector<PictureMember> members;   ///< not of a group
  std::string data;                     ///< C++ type, of groups that are alike that of each; empty: none
  std::optional<std::string> requested; ///< the program requests it, with this priority
  std::vector<std::string> roots;       ///< the groups that the program requests
  std::vector<PictureLine> lines;       ///< of its handlers
  std::vector<PictureRow> rows;         ///< of a group
  bool in_focus = false;
  std::optional<Moment::Mark> mark;     ///< nothing: no moment is shown
  std::string note;                     ///< about the mark; none if it is folded: its members have them
  std::vector<Moment::Standing> frames; ///< its marks and notes in all frames, each once: they need space
  PictureText about;

  /// Its only row is the direct provider of the group.
  bool is_direct() const { return rows.size() == 1 && rows.front().name.empty(); }
};

/// A band, from top to bottom.
struct PictureLayer {
  std::string name;      ///< empty: what is in no layer
  bool is_above = false; ///< what is in no layer, and leads to those that are
  bool in_order = false; ///< each of its boxes stands below the one before
  std::vector<std::size_t> boxes;
  std::vector<std::size_t> first,
      last; ///< boxes of it that no other box of it leads to, or that lead to no box of it
  std::string label() const { return name.empty() ? "no layer here" : name; }
  /// Different for each layer.
  std::string title() const {
    if (!name.empty()) return "layer " + name;
    return is_above ? label() + ", above all layers" : label();
  }
};

/// Where an arrow begins or ends.
struct PictureEnd {
  std::size_t box = 0;
  std::optional<std::size_t> row;  ///< nothing: the whole box
  std::optional<std::size_t> pack; ///< of that row
  auto operator<=>(const PictureEnd&) const = default;
};

struct PictureArrow {
  enum class Kind {
    task, ///< may request
    need,
    both,
    push, ///< from the waiting group to the pushed one
    take, ///< by its rank the first may take something from the second
  };
  PictureEnd from, to;
  Kind kind = Kind::task;
  bool optional = false;            ///< wherever it is requested
  bool apart = false;               ///< likewise
  std::string label;                ///< priorities; of a push the conditions, one a line
  bool missing = false;             ///< it leads to a name that no group has
  bool ranks = true;                ///< the second box is to be below the first
  std::optional<Moment::Mark> mark; ///< empty: no moment is shown
  bool hidden = false;              ///< it needs space, as another frame shows it
  PictureText about;
  bool operator==(const PictureArrow&) const = default;
};

struct Picture {
  std::string title;
  std::string doc;
  std::string moment;               ///< the title of the shown moment; empty: none
  std::vector<std::string> values;  ///< of states, at that moment
  std::size_t longest_head = 0;     ///< letters of the longest title or value in all frames
  std::vector<std::string> wrong;   ///< findings that are about no box
  std::string nothing;              ///< why there is no box; empty: there are some
  bool packs_left_out = false;      ///< there are so many boxes that an arrow represents all providers and packs
  std::vector<PictureLayer> layers; ///< in the order declared; boxes in none are first if they lead there, else last
  std::vector<PictureBox> boxes;
  std::vector<PictureArrow> arrows;                          ///< by box
  std::size_t all_groups = 0;                                ///< of the behaviour, whether they are drawn or not
  PictureOptions::Fold fold = PictureOptions::Fold::nothing; ///< what each box is
  std::vector<PictureArrow::Kind> kinds;                     ///< that the view shows
};

Picture make_picture(const Model& model, const Graph& graph, const dsl::Sources& sources,
                     const PictureOptions& options = {});

/// The content of a picture as text, for screen readers: the number of things of each kind.
std::string summary(const Picture& picture);

} // namespace director::compiler
