#include "app/tools/text/text_keys.h"

#include "app/session/commands/keys.h"
#include "app/session/lettering/text_entry.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMimeData>

namespace suffuse {

bool TextKeys::areMeant(const QKeyEvent &event) const
{
    const bool isFunction = event.key() >= Qt::Key_F1 && event.key() <= Qt::Key_F35;
    if (isTypedKey(QKeyCombination(event.modifiers(), Qt::Key(event.key()))))
        return !isFunction && event.key() != Qt::Key_unknown;
    auto &key = const_cast<QKeyEvent &>(event); // `matches` asks, and changes nothing
    if (key.matches(QKeySequence::Undo))
        return m_entry.hasTyped();
    if (meansRedo(event))
        return m_entry.canTypeAgain();
    for (const auto standard :
         {QKeySequence::SelectAll, QKeySequence::Copy, QKeySequence::Cut, QKeySequence::Paste,
          QKeySequence::MoveToNextWord, QKeySequence::MoveToPreviousWord, QKeySequence::SelectNextWord,
          QKeySequence::SelectPreviousWord, QKeySequence::MoveToStartOfDocument, QKeySequence::MoveToEndOfDocument,
          QKeySequence::SelectStartOfDocument, QKeySequence::SelectEndOfDocument, QKeySequence::DeleteStartOfWord,
          QKeySequence::DeleteEndOfWord})
        if (key.matches(standard))
            return true;
    // AltGr and the like type letters with modifiers.
    return (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) == (Qt::ControlModifier | Qt::AltModifier) &&
           !event.text().isEmpty() && event.text()[0].isPrint();
}

/// The place above, below or beside the caret, as it is seen before the text's own place is applied.
qsizetype TextKeys::placeBeside(int dx, int dy)
{
    const LaidText &laid = m_entry.laid();
    const QString &string = m_entry.text().string;
    const bool isVertical = m_entry.text().vertical && m_entry.text().curve.empty();
    const int along = isVertical ? dy : dx, across = isVertical ? -dx : dy;
    const qsizetype caret = m_entry.caret();
    const int line = laid.lineOf(caret);
    if (along != 0) {
        m_column.reset();
        const bool isBackwards = !isVertical && laid.lines[std::size_t(line)].rightToLeft;
        return (along > 0) != isBackwards ? nextPlace(string, caret) : placeBefore(string, caret);
    }
    const int other = line + across;
    if (other < 0)
        return 0;
    if (other >= int(laid.lines.size()))
        return string.size();
    const CaretLine at = laid.caretAt(caret);
    const Point middle = 0.5 * (at[0] + at[1]);
    if (!m_column)
        m_column = isVertical ? middle.y : middle.x;
    const double step = double(m_entry.text().lineHeight) * m_entry.text().size * across;
    Point aim = isVertical ? Point{middle.x - step, *m_column} : Point{*m_column, middle.y + step};
    if (!m_entry.text().curve.empty()) {
        const Point down = at[1] - at[0];
        aim = middle + (step / std::max(1e-300, length(down))) * down;
    }
    return laid.positionInLine(other, aim, string);
}

bool TextKeys::moveCaret(QKeyEvent &event)
{
    const bool selects = event.modifiers() & Qt::ShiftModifier;
    const bool ctrl = event.modifiers() & Qt::ControlModifier;
    const QString &string = m_entry.text().string;
    const LaidLine &line = m_entry.laid().lines[std::size_t(m_entry.laid().lineOf(m_entry.caret()))];
    if (event.modifiers() & (Qt::AltModifier | Qt::MetaModifier))
        return false;
    const std::optional<double> column = m_column;
    m_column.reset();
    const bool forward = event.key() == Qt::Key_Right || event.key() == Qt::Key_Down;
    switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down: {
        const bool isAcross = event.key() == Qt::Key_Left || event.key() == Qt::Key_Right;
        if (ctrl) {
            m_entry.moveTo(forward ? nextWord(string, m_entry.caret()) : wordBefore(string, m_entry.caret()), selects);
            return true;
        }
        const bool isVertical = m_entry.text().vertical && m_entry.text().curve.empty();
        if (m_entry.hasSelection() && !selects && isAcross != isVertical) {
            const auto [from, to] = std::minmax({m_entry.caret(), m_entry.anchor()});
            m_entry.moveTo(forward != line.rightToLeft ? to : from, false);
            return true;
        }
        m_column = column;
        const int step = forward ? 1 : -1;
        const qsizetype to = isAcross ? placeBeside(step, 0) : placeBeside(0, step);
        const std::optional<double> kept = m_column;
        m_entry.moveTo(to, selects);
        m_column = kept;
        return true;
    }
    case Qt::Key_Home:
        m_entry.moveTo(ctrl ? 0 : line.from, selects);
        return true;
    case Qt::Key_End:
        m_entry.moveTo(ctrl ? string.size() : line.to, selects);
        return true;
    default:
        return false;
    }
}

bool TextKeys::doEditing(QKeyEvent &event)
{
    const QString &string = m_entry.text().string;
    const bool ctrl = event.modifiers() & Qt::ControlModifier;
    if (event.matches(QKeySequence::Undo))
        return m_entry.takeBack();
    if (meansRedo(event))
        return m_entry.typeAgain();
    if (event.matches(QKeySequence::SelectAll)) {
        m_entry.select(0, string.size());
    } else if (event.matches(QKeySequence::Copy) || event.matches(QKeySequence::Cut)) {
        if (!m_entry.hasSelection())
            return true;
        QGuiApplication::clipboard()->setText(m_entry.selectedString());
        if (event.matches(QKeySequence::Cut))
            m_entry.eraseTo(m_entry.caret());
    } else if (event.matches(QKeySequence::Paste)) {
        if (const QMimeData *data = QGuiApplication::clipboard()->mimeData(); data && data->hasText())
            m_entry.type(data->text());
    } else if (event.key() == Qt::Key_Backspace) {
        m_entry.eraseTo(ctrl ? wordBefore(string, m_entry.caret()) : placeBefore(string, m_entry.caret()));
    } else if (event.key() == Qt::Key_Delete) {
        m_entry.eraseTo(ctrl ? nextWord(string, m_entry.caret()) : nextPlace(string, m_entry.caret()));
    } else {
        return false;
    }
    return true;
}

bool TextKeys::take(QKeyEvent &event)
{
    if (event.key() == Qt::Key_Escape) {
        m_entry.finish();
        return true;
    }
    const bool isModifier = event.key() == Qt::Key_Shift || event.key() == Qt::Key_Control ||
                            event.key() == Qt::Key_Alt || event.key() == Qt::Key_Meta || event.key() == Qt::Key_AltGr;
    if (isModifier)
        return false;
    if (moveCaret(event) || doEditing(event))
        return true;
    m_column.reset();
    QString text = event.text();
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
        text = QStringLiteral("\n");
    if (!text.isEmpty() && (text[0].isPrint() || text[0] == QLatin1Char('\t') || text[0] == QLatin1Char('\n')))
        m_entry.type(text);
    return true; // Whatever else is typed means no command while a text is in hand.
}

} // namespace suffuse
