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

/// A page of fields that show a brush. What is entered comes out as a change of the brush; the page shows it when it is
/// told of it.
class BrushPage : public QWidget {
    Q_OBJECT

public:
    virtual void showBrush(const Brush &brush);
    SliderField *field(const QString &name) const; ///< by its label; null if there is none

signals:
    void changed(const std::function<void(suffuse::Brush &)> &apply);
    /// What was typed into a field is no value of it, and why.
    void refused(const QString &hint);

protected:
    using Get = std::function<double(const Brush &)>;
    using Set = std::function<void(Brush &, double)>;

    explicit BrushPage(QWidget *parent);
    QVBoxLayout &column() const { return *m_column; }
    /// A field in the next row of the grid, for a number of the brush.
    SliderField *bind(QGridLayout &grid, const FieldSpec &spec, const Get &get, const Set &set);

private:
    /// A field and the value that it shows.
    struct Bound {
        SliderField *field;
        QString name;
        Get get;
    };

    QVBoxLayout *m_column;
    std::vector<Bound> m_bound;
};

} // namespace suffuse
