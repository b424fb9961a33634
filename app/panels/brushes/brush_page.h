// What the pages of the brush's settings have in common.
#pragma once

#include "model/brush/brush.h"

#include <QWidget>

#include <functional>
#include <vector>

class QGridLayout;
class QVBoxLayout;

namespace suffuse {

class SliderField;
struct FieldSpec;

/// A page of fields that show a brush. What is entered is emitted as a change of the brush; the page shows it when
/// `showBrush` brings it back.
class BrushPage : public QWidget {
    Q_OBJECT

public:
    /// Shows the brush in all fields.
    virtual void showBrush(const Brush &brush);
    SliderField *field(const QString &name) const; ///< by its label; null if there is none

signals:
    /// Emitted when something was entered; `apply` makes the change to a brush.
    void changed(const std::function<void(suffuse::Brush &)> &apply);
    /// Emitted when a text that was typed into a field is no value of it; says why.
    void refused(const QString &hint);

protected:
    using Get = std::function<double(const Brush &)>;
    using Set = std::function<void(Brush &, double)>;

    explicit BrushPage(QWidget *parent);
    QVBoxLayout &column() const { return *m_column; }
    /// Adds a field for a number of the brush to the next row of the grid.
    SliderField *bind(QGridLayout &grid, const FieldSpec &spec, const Get &get, const Set &set);

private:
    /// A field, and how to get the value that it shows.
    struct Bound {
        SliderField *field;
        QString name;
        Get get;
    };

    QVBoxLayout *m_column;
    std::vector<Bound> m_bound;
};

} // namespace suffuse
