#pragma once

#include "app/session/fitting/fit_job.h"

#include <QWidget>

class QComboBox;
class QGridLayout;
class QToolButton;

namespace suffuse {

class NumberField;
class SliderField;

/// How a picture is to be fitted, as rows of fields. What was chosen last is there the next time.
class FitRows : public QWidget {
    Q_OBJECT

public:
    static constexpr double mostStrokes = 20'000;

    explicit FitRows(QWidget *parent);

    /// Asks for a quarter of so many strokes, and lets the slider choose among fewer.
    void aimBelow(int strokes);

    /// What the rows say. Widths are in units of the canvas, of which the caller makes pixels.
    FitWish wish() const;
    /// Keeps it for the next time.
    void remember() const;

    SliderField *strokes() const { return m_strokes; }
    QComboBox *detail() const { return m_detail; }
    QComboBox *style() const { return m_style; }
    QComboBox *colours() const { return m_colours; }
    NumberField *paints() const { return m_paints; }
    NumberField *leastWidth() const { return m_least; }
    NumberField *greatestWidth() const { return m_greatest; }
    NumberField *seed() const { return m_seed; }
    QToolButton *more() const { return m_more; }

signals:
    /// Another fit is wanted. While a slider is dragged, nothing is said.
    void changed();
    /// A typed number was refused, and `hint` says why.
    void refused(const QString &hint);

private:
    void addStrokes(QGridLayout &grid);
    void addChoices(QGridLayout &grid);
    void addMore(QGridLayout &grid);
    QComboBox *addCombo(QGridLayout &grid, const QString &name, const QString &tip, const QStringList &items);
    NumberField *addNumber(QGridLayout &grid, const QString &name, const QString &tip, double least, double most,
                           bool isWhole);

    SliderField *m_strokes = nullptr;
    QComboBox *m_detail = nullptr;
    QComboBox *m_style = nullptr;
    QComboBox *m_colours = nullptr;
    NumberField *m_paints = nullptr;
    NumberField *m_least = nullptr;
    NumberField *m_greatest = nullptr;
    NumberField *m_seed = nullptr;
    QToolButton *m_more = nullptr;
};

} // namespace suffuse
