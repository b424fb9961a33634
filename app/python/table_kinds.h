// Which tables there are, and of what their rows are made.
#pragma once

#include "app/python/columns.h"
#include "app/python/tables.h"

#include <QStringList>

#include <optional>

namespace suffuse::python {

/// How the rows of a table say what they belong to, and how a column is called whose type has no fields.
template <class T>
struct TableOf;
template <>
struct TableOf<Canvas> {
    static constexpr const char *name = "canvas", *owner = nullptr, *lone = nullptr;
};
template <>
struct TableOf<Stroke> {
    static constexpr const char *name = "strokes", *owner = nullptr, *lone = nullptr;
};
template <>
struct TableOf<Segment> {
    static constexpr const char *name = "segments", *owner = "stroke", *lone = nullptr;
};
template <>
struct TableOf<Rewet> {
    static constexpr const char *name = "rewets", *owner = "segment", *lone = "wetting";
};
template <>
struct TableOf<Fill> {
    static constexpr const char *name = "fills", *owner = "stroke", *lone = nullptr;
};
template <>
struct TableOf<Picture> {
    static constexpr const char *name = "pictures", *owner = "stroke", *lone = nullptr;
};
template <>
struct TableOf<Group> {
    static constexpr const char *name = "groups", *owner = nullptr, *lone = nullptr;
};
template <>
struct TableOf<Text> {
    static constexpr const char *name = "texts", *owner = "group", *lone = nullptr;
};
template <>
struct TableOf<Cubic> {
    static constexpr const char *name = "text_curves", *owner = "text", *lone = "bezier";
};
template <>
struct TableOf<Swatch> {
    static constexpr const char *name = "swatches", *owner = nullptr, *lone = nullptr;
};
template <>
struct TableOf<Underlay> {
    static constexpr const char *name = "underlay", *owner = nullptr, *lone = nullptr;
};

/// Calls use(T()) with the type of the rows of a table.
template <class Use>
auto withTable(const std::string &name, Use use)
{
    using Result = decltype(use(Canvas()));
    std::optional<Result> result;
    const auto tryType = [&](auto usual) {
        if (!result && name == TableOf<decltype(usual)>::name)
            result.emplace(use(usual));
    };
    tryType(Canvas()), tryType(Stroke()), tryType(Segment()), tryType(Rewet()), tryType(Fill()), tryType(Picture());
    tryType(Group()), tryType(Text()), tryType(Cubic()), tryType(Swatch()), tryType(Underlay());
    if (!result) {
        QStringList names;
        for (const std::string &known : tableNames())
            names.append(QString::fromStdString(known));
        raise(Raised::Value, QStringLiteral("%1: there is no such table; give one of %2")
                                 .arg(QString::fromStdString(name), names.join(QStringLiteral(", "))));
    }
    return *result;
}

template <class T>
ColumnList columnListOf(const std::vector<std::size_t> &widths = {})
{
    ColumnList list(widths);
    if constexpr (TableOf<T>::owner != nullptr)
        list.add(TableOf<T>::owner, RowNumber());
    T usual{};
    if constexpr (TableOf<T>::lone != nullptr)
        list.add(TableOf<T>::lone, usual, {.unit = std::is_same_v<T, Rewet> ? Unit::Seconds : Unit::Length});
    else
        walkColumns(usual, list);
    return list;
}

} // namespace suffuse::python
