// SPDX-License-Identifier: Apache-2.0
// Built from the parser's events, not from its own tree: that one forgets where keys stand, keeps the last of two equal
// keys in silence, and lets aliases share nodes.
#include "facies/scenario/yaml_tree.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

namespace facies::scenario {

namespace {

constexpr std::size_t max_depth = 16;  // a scenario needs 5

/// Ends the parsing with one problem that makes the rest of the document worthless.
struct Refused {
  Problem problem;
};

class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(const Origin& origin, Problems& problems) : origin_(origin), problems_(problems) {}

  YamlNode take() { return std::move(root_); }

  [[nodiscard]] std::string place(const YAML::Mark& mark) const {
    if (!origin_.count_lines || mark.is_null()) return origin_.name;
    return fmt::format("{}:{}:{}", origin_.name, mark.line + 1, mark.column + 1);
  }

  void OnDocumentStart(const YAML::Mark& /*mark*/) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuse_anchor(mark, anchor);
    YamlNode node;
    node.where = place(mark);
    finish(std::move(node));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override {
    refuse_anchor(mark, 1);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    YamlNode node;
    node.kind = YamlNode::Kind::scalar;
    node.text = value;
    node.where = place(mark);
    finish(std::move(node));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    start(YamlNode::Kind::sequence, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    start(YamlNode::Kind::mapping, mark, tag, anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  /// A list or mapping that is still open; of a mapping also the key that waits for its value.
  struct Open {
    YamlNode node;
    bool has_key = false;
    bool repeated = false;
    YamlEntry pending;
    std::vector<std::string> keys;  // sorted
  };

  void refuse_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) const {
    if (anchor == 0) return;
    throw Refused{
        {place(mark), "an anchor or alias", "a value written out", "scenarios have none"}};
  }

  void refuse_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?" || tag == "!") return;
    throw Refused{{place(mark), fmt::format("the tag '{}'", tag), "a value without a tag", ""}};
  }

  void start(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag,
             YAML::anchor_t anchor) {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    if (open_.size() >= max_depth) {
      throw Refused{{place(mark), fmt::format("more than {} levels", max_depth), "", ""}};
    }
    Open opened;
    opened.node.kind = kind;
    opened.node.where = place(mark);
    open_.push_back(std::move(opened));
  }

  void close() {
    YamlNode node = std::move(open_.back().node);
    open_.pop_back();
    finish(std::move(node));
  }

  void finish(YamlNode node) {
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    Open& parent = open_.back();
    if (parent.node.kind == YamlNode::Kind::sequence) {
      parent.node.items.push_back(std::move(node));
    } else if (!parent.has_key) {
      take_key(parent, node);
    } else {
      parent.has_key = false;
      // The parser places a missing value at whatever comes next; people look for it at its key.
      if (node.kind == YamlNode::Kind::nothing) node.where = parent.pending.where;
      parent.pending.value = std::move(node);
      if (!parent.repeated) parent.node.entries.push_back(std::move(parent.pending));
    }
  }

  void take_key(Open& parent, const YamlNode& key) {
    parent.has_key = true;
    parent.pending = {key.text, key.where, {}};
    const auto position = std::lower_bound(parent.keys.begin(), parent.keys.end(), key.text);
    parent.repeated = true;
    if (key.kind != YamlNode::Kind::scalar) {
      problems_.add({key.where, describe(key) + " as a key", "a word", ""});
    } else if (position != parent.keys.end() && *position == key.text) {
      problems_.add({key.where, fmt::format("'{}' is given twice", key.text), "",
                     fmt::format("the first one is at {}", parent.node.find(key.text)->where)});
    } else {
      parent.repeated = false;
      parent.keys.insert(position, key.text);
    }
  }

  const Origin& origin_;
  Problems& problems_;
  YamlNode root_;
  std::vector<Open> open_;
};

}  // namespace

const YamlEntry* YamlNode::find(std::string_view key) const {
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [&](const YamlEntry& e) { return e.key == key; });
  return entry == entries.end() ? nullptr : &*entry;
}

YamlEntry* YamlNode::find(std::string_view key) {
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [&](const YamlEntry& e) { return e.key == key; });
  return entry == entries.end() ? nullptr : &*entry;
}

std::string describe(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::nothing:
      return "nothing";
    case YamlNode::Kind::scalar:
      return fmt::format("the value '{}'", node.text);
    case YamlNode::Kind::sequence:
      return "a list";
    case YamlNode::Kind::mapping:
      return "a mapping";
  }
  return {};
}

YamlNode parse_yaml(const std::string& text, const Origin& origin, Problems& problems) {
  TreeBuilder builder(origin, problems);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder))
      return {YamlNode::Kind::nothing, {}, {}, {}, origin.name};
    YamlNode root = builder.take();
    TreeBuilder rest(origin, problems);
    if (parser.HandleNextDocument(rest)) {
      problems.add({rest.take().where, "a second document", "one document per file", ""});
    }
    return root;
  } catch (const Refused& refused) {
    problems.add(refused.problem);
  } catch (const YAML::Exception& error) {
    problems.add({builder.place(error.mark), "not YAML: " + error.msg, "",
                  "look for wrong indentation, a missing colon or an open quote or bracket"});
  }
  return {YamlNode::Kind::nothing, {}, {}, {}, origin.name};
}

}  // namespace facies::scenario
