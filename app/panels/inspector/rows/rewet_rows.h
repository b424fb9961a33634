#pragma once

#include "app/panels/inspector/inspected.h"

#include <QWidget>

class QVBoxLayout;

namespace suffuse {

class Editor;

/// Shows when the inspected segments are wetted again: a row for each time, with a button that removes it. It is hidden
/// where no segment is wetted again.
class RewetRows : public QWidget {
    Q_OBJECT

public:
    explicit RewetRows(Editor &editor, QWidget *parent = nullptr);

    void refresh(const Inspected &inspected);

private:
    /// A time at which some or all of the segments are wetted again.
    struct Row {
        Rewet rewet;
        bool ofAll = false;
        friend bool operator==(const Row &, const Row &) = default;
    };
    void show(const std::vector<Row> &rows, bool more);
    void addRow(const Row &row);

    Editor &m_editor;
    std::vector<Row> m_rows;
    bool m_more = false;
    QWidget *m_list = nullptr;
    QVBoxLayout *m_column = nullptr;
};

} // namespace suffuse
