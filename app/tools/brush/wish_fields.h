// The fields of the attribute brush that say what it paints.
#pragma once

#include "app/session/painting/attribute_brush.h"

#include <QObject>

class QComboBox;
class QHBoxLayout;
class QLabel;

namespace suffuse {

class NumberField;

/// The fields for what is painted onto segments, for whether it leads towards a value or adds to the segments' own, and
/// for the value. They belong to the row that they are added to.
class WishFields : public QObject {
    Q_OBJECT

public:
    /// Adds the fields to a row.
    explicit WishFields(QHBoxLayout &row);

    /// Shows a wish, and emits nothing.
    void show(const AttributeWish &wish);

signals:
    /// Emitted when somebody has changed the wish by hand.
    void wishChanged(const suffuse::AttributeWish &wish);

private:
    /// Takes another quantity, with the value that is usual for it.
    void choose(Attribute attribute, bool relative);

    AttributeWish m_wish;
    QComboBox *m_attributes = nullptr;
    QComboBox *m_modes = nullptr;
    QLabel *m_valueLabel = nullptr;
    NumberField *m_value = nullptr;
};

} // namespace suffuse
