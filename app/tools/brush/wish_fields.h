// The fields of the attribute brush that say what it paints.
#pragma once

#include "app/session/painting/attribute_brush.h"

#include <QObject>

class QComboBox;
class QHBoxLayout;
class QLabel;

namespace suffuse {

class NumberField;

/// What is painted onto segments, whether towards a value or from theirs, and the value. They go with the row that they
/// are added to.
class WishFields : public QObject {
    Q_OBJECT

public:
    explicit WishFields(QHBoxLayout &row);

    void show(const AttributeWish &wish);

signals:
    /// By hand.
    void wishChanged(const suffuse::AttributeWish &wish);

private:
    /// The value becomes what is usual.
    void choose(Attribute attribute, bool relative);

    AttributeWish m_wish;
    QComboBox *m_attributes = nullptr;
    QComboBox *m_modes = nullptr;
    QLabel *m_valueLabel = nullptr;
    NumberField *m_value = nullptr;
};

} // namespace suffuse
