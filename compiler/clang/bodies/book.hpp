#pragma once
// SPDX-License-Identifier: MIT
// Collects the facts of a unit: classes that implement modules, and functions, each read once, in the order in which
// they are found.

#include "compiler/clang/ast/contexts.hpp"
#include "compiler/clang/ast/places.hpp"
#include "compiler/clang/bodies/reach.hpp"

#include <clang/AST/ASTContext.h>

#include <set>
#include <string>
#include <vector>

namespace clang {
class Sema;
} // namespace clang

namespace director::scanning {

class Book {
public:
  /// `is_deep`: bodies of functions in system headers are available, to find what blocks.
  Book(clang::ASTContext& context, const std::string& directory, bool is_deep)
      : context_(context),
        places_(context, directory),
        is_deep_(is_deep) {}

  /// The key of the function, which is queued if it has a visible body.
  std::string want(const clang::FunctionDecl& function);
  /// The next queued function; null: all have been read.
  const clang::FunctionDecl* next();

  clang::ASTContext& context() { return context_; }
  Places& places() { return places_; }
  Reach& reach() { return reach_; }
  Carriers& carriers() { return carriers_; }
  bool is_deep() const { return is_deep_; }
  std::vector<Json> functions, classes;
  std::set<std::string> continued; ///< keys of classes from which a class template derives
  std::set<std::string> runs;      ///< keys of the bodies of modules of which an object is made
  bool has_templates = false;      ///< one has bodies, or a module among its bases

private:
  clang::ASTContext& context_;
  Places places_;
  Reach reach_;
  Carriers carriers_;
  bool is_deep_;
  std::set<const clang::Decl*> wanted_;
  std::vector<const clang::FunctionDecl*> waiting_;
};

/// A name that is the same for one function in all files, and different for functions that are local to different
/// files.
std::string key_of(const clang::NamedDecl& decl);

/// instantiate.cpp: the bodies that a class inherits from a template, also if no file makes an object of it, and
/// deleters that are templates, which only the library's code calls.
void instantiate_bodies(clang::Sema& sema);
/// classes.cpp: the classes of the unit that implement modules. Queues the functions to begin with.
void find_classes(Book& book);
/// bodies.cpp: what a function does with respect to a behaviour, and the functions that it calls, which it queues.
void read_function(Book& book, const clang::FunctionDecl& function);

} // namespace director::scanning
