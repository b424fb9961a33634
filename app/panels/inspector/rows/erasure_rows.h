#pragma once

#include "app/panels/inspector/inspected.h"
#include "app/panels/inspector/rows/combo_row.h"

#include <QObject>

class QGridLayout;

namespace suffuse {

class Editor;
class SliderField;
class ValueEntry;
struct ValueChange;

/// What an erasure is: whether it fades or lifts, and of one that fades the share of the paint that it takes. They are
/// rows of a grid, and shown where all that is inspected takes paint away.
class ErasureRows : public QObject {
    Q_OBJECT

public:
    ErasureRows(Editor &editor, QGridLayout &grid, QWidget *parent);

    /// Returns whether all of it fades: then the share stands for the density.
    bool refresh(const Inspected &inspected);

    QComboBox *kind() const { return m_kind.box; }
    SliderField *share() const { return m_share; }

signals:
    void refused(const QString &hint);

private:
    void setFade(bool fade);
    void setShare(double share, ValueEntry *entry);
    void changeShares(const ValueChange &change, ValueEntry *entry);

    Editor &m_editor;
    ComboRow m_kind;
    SliderField *m_share = nullptr;
};

} // namespace suffuse
