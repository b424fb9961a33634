#include "app/session/lettering/text_entry.h"

#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "undo/history/restore_edit.h"
#include "undo/text_edits.h"

#include <QScopedValueRollback>

namespace suffuse {

namespace {

constexpr std::size_t mostSteps = 1'000;

/// Line ends as one \n, and nothing that is no valid Unicode.
QString clean(QString characters)
{
    characters.replace(QLatin1String("\r\n"), QLatin1String("\n"));
    for (const QChar end : {QChar(u'\r'), QChar(QChar::LineSeparator), QChar(QChar::ParagraphSeparator)})
        characters.replace(end, QLatin1Char('\n'));
    if (!characters.isValidUtf16())
        characters = QString::fromUtf8(characters.toUtf8());
    return characters;
}

/// Where what `after` has in place of a part of `before` ends in it. No value if they are the same.
std::optional<qsizetype> endOfChange(const QString &before, const QString &after)
{
    if (before == after)
        return {};
    const qsizetype shorter = std::min(before.size(), after.size());
    qsizetype first = 0, last = 0; // characters that both begin and end with
    while (first < shorter && before[first] == after[first])
        ++first;
    while (last < shorter - first && before[before.size() - 1 - last] == after[after.size() - 1 - last])
        ++last;
    return after.size() - last;
}

double scaleOf(const Affine &map)
{
    return std::sqrt(std::abs(map.determinant()));
}

} // namespace

TextEntry::TextEntry(Editor &editor, QObject *parent) : QObject(parent), m_editor(editor)
{
    connect(&editor.document(), &Document::changed, this, &TextEntry::follow);
}

void TextEntry::begin(const Text &text)
{
    finish();
    m_group = m_editor.document().takeGroupId();
    m_text = text;
    m_text.string.clear();
    m_shown = m_text;
    m_laid = m_layout.lay(m_shown);
    m_plain = m_editor.document().painting();
    m_caret = m_anchor = 0;
    m_isOpen = true;
    m_isOld = m_isThere = false;
    m_wasWarned = true; // The row has said which font it is.
    emit opened();
    emit changed();
}

void TextEntry::open(GroupId group)
{
    finish();
    const Painting &painting = *m_editor.document().painting();
    const SharedText text = textOf(painting, group);
    if (!text)
        return;
    if (isTextLocked(painting, group)) {
        emit locked();
        return;
    }
    m_group = group;
    m_text = m_shown = *text;
    m_laid = m_layout.lay(m_shown);
    m_plain = m_editor.document().painting();
    m_caret = m_anchor = m_text.string.size();
    m_isOpen = true;
    m_isOld = m_isThere = true;
    m_wasWarned = false;
    m_editor.document().setSelection({});
    emit opened();
    emit changed();
}

void TextEntry::settle()
{
    if (!m_isOpen)
        return;
    compose({}, 0);
    m_gesture.commit();
    keepForRedo();
    m_past.clear();
    m_future.clear();
    m_last = Kind::None;
}

void TextEntry::finish()
{
    settle();
    if (!m_isOpen)
        return;
    const GroupId group = m_group;
    const bool isThere = textOf(*m_editor.document().painting(), group) == SharedText(m_shown);
    close();
    if (!isThere)
        return;
    if (const std::set<StrokeId> letters = strokesWithin(*m_editor.document().painting(), group); !letters.empty())
        m_editor.document().setSelection({letters, {}});
}

void TextEntry::giveUp()
{
    if (!m_isOpen)
        return;
    {
        const QScopedValueRollback shows(m_shows, true);
        m_gesture.giveUp();
    }
    close();
}

void TextEntry::close()
{
    m_isOpen = false;
    m_gesture.commit();
    m_group = 0;
    m_plain.reset();
    m_emptied.reset();
    m_preedit.clear();
    m_past.clear();
    m_future.clear();
    m_last = Kind::None;
    m_usesBrush = false;
    emit closed();
}

QString TextEntry::selectedString() const
{
    return m_text.string.mid(std::min(m_caret, m_anchor), std::abs(m_caret - m_anchor));
}

std::set<StrokeId> TextEntry::selectedLetters()
{
    std::set<StrokeId> out;
    if (!hasSelection())
        return out;
    const std::vector<StrokeId> letters = lettersOf(*m_editor.document().painting(), m_group, m_laid);
    const auto [from, to] = std::minmax({m_caret, m_anchor});
    std::size_t k = 0;
    for (const LaidCluster &cluster : m_laid.clusters) {
        if (!cluster.hasInk())
            continue;
        if (k < letters.size() && letters[k] && cluster.from >= from && cluster.to <= to)
            out.insert(letters[k]);
        ++k;
    }
    return out;
}

void TextEntry::moveTo(qsizetype position, bool selects)
{
    select(selects ? m_anchor : position, position);
}

void TextEntry::select(qsizetype from, qsizetype to)
{
    compose({}, 0);
    m_anchor = std::clamp<qsizetype>(from, 0, m_text.string.size());
    m_caret = std::clamp<qsizetype>(to, 0, m_text.string.size());
    m_last = Kind::None;
    m_usesBrush = false;
    emit changed();
}

void TextEntry::note(Kind kind, bool goesOn)
{
    // What somebody else has made a step of is not taken back here.
    if (!m_past.empty() && !m_editor.undecided())
        m_past.clear();
    if (!(goesOn && m_last == kind && !m_past.empty())) {
        m_past.push_back(state());
        if (m_past.size() > mostSteps)
            m_past.erase(m_past.begin());
    }
    m_future.clear();
    m_last = kind;
}

bool TextEntry::refusesForFont()
{
    if (!m_isOld || m_wasWarned || m_laid.hasFamily)
        return false;
    m_wasWarned = true;
    emit fontMissing(m_text.family);
    return true;
}

void TextEntry::replace(qsizetype from, qsizetype to, const QString &characters, Kind kind)
{
    if ((from == to && characters.isEmpty()) || refusesForFont())
        return;
    const qsizetype room = Text::mostCharacters - (m_text.string.size() - (to - from));
    QString put = characters.left(std::max<qsizetype>(0, room));
    if (!put.isEmpty() && put.back().isHighSurrogate())
        put.chop(1);
    // Letters follow each other as one step up to the next word.
    const bool goesOn =
        from == to || kind == Kind::Erased ? put.size() <= 2 && !put.contains(QLatin1Char('\n')) : false;
    const bool beginsWord = !put.isEmpty() && put[0].isSpace();
    note(kind, goesOn && !beginsWord);
    m_text.string.replace(from, to - from, put);
    m_caret = m_anchor = from + put.size();
    show(from);
}

void TextEntry::type(const QString &characters)
{
    if (!m_isOpen)
        return;
    compose({}, 0);
    const auto [from, to] = std::minmax({m_caret, m_anchor});
    replace(from, to, clean(characters), Kind::Typed);
}

void TextEntry::eraseTo(qsizetype position)
{
    if (!m_isOpen)
        return;
    compose({}, 0);
    const auto [from, to] = hasSelection() ? std::minmax({m_caret, m_anchor}) : std::minmax({m_caret, position});
    replace(from, to, {}, Kind::Erased);
}

void TextEntry::change(const std::function<void(Text &)> &how)
{
    if (!m_isOpen)
        return;
    compose({}, 0);
    Text text = m_text;
    how(text);
    text.string = m_text.string;
    if (text == m_text)
        return;
    note(Kind::Changed, true);
    m_text = std::move(text);
    show({});
}

void TextEntry::compose(const QString &preedit, qsizetype caret)
{
    if (!m_isOpen || (preedit.isEmpty() && m_preedit.isEmpty()))
        return;
    if (!preedit.isEmpty()) {
        if (m_preedit.isEmpty() && refusesForFont())
            return;
        if (hasSelection()) {
            const auto [from, to] = std::minmax({m_caret, m_anchor});
            replace(from, to, {}, Kind::Erased);
        }
    }
    m_preedit = clean(preedit);
    m_preeditCaret = std::clamp<qsizetype>(caret, 0, m_preedit.size());
    show(m_caret);
}

void TextEntry::decide(const QString &characters, qsizetype start, qsizetype length)
{
    if (!m_isOpen)
        return;
    m_preedit.clear(); // What was composed goes with what is decided, in one change.
    const qsizetype size = m_text.string.size();
    qsizetype from = std::min(m_caret, m_anchor), to = std::max(m_caret, m_anchor);
    if (start != 0 || length != 0) {
        from = std::clamp<qsizetype>(m_caret + start, 0, size);
        to = std::clamp<qsizetype>(from + length, from, size);
    }
    if (characters.isEmpty() && from == to)
        show(from);
    else
        replace(from, to, clean(characters), Kind::Typed);
}

bool TextEntry::hasTyped() const
{
    return m_isOpen && !m_past.empty() && m_editor.undecided();
}

bool TextEntry::takeBack()
{
    if (!hasTyped()) {
        keepForRedo();
        return false;
    }
    compose({}, 0);
    m_future.push_back(state());
    const State before = std::move(m_past.back());
    m_past.pop_back();
    restore(before);
    return true;
}

bool TextEntry::typeAgain()
{
    if (!m_isOpen || m_future.empty())
        return false;
    compose({}, 0);
    m_past.push_back(state());
    const State after = std::move(m_future.back());
    m_future.pop_back();
    restore(after);
    return true;
}

void TextEntry::restore(const State &state)
{
    m_text = state.text;
    m_caret = state.caret;
    m_anchor = state.anchor;
    m_last = Kind::None;
    if (!state.painting) {
        show(std::min(m_caret, m_anchor));
        return;
    }
    m_laid = m_layout.lay(m_text);
    put(restorePainting(m_editor.document(), *state.painting), m_text);
    emit changed();
}

/// What was taken back becomes a step that is undone: it can be redone then like any other one.
void TextEntry::keepForRedo()
{
    if (m_future.empty())
        return;
    const State last = std::move(m_future.front());
    m_past.clear();
    m_future.clear();
    restore(last);
    m_gesture.commit();
    m_editor.undo();
}

/// Puts an edit of the document in, after which it shows a text.
void TextEntry::put(Edit edit, Text shown)
{
    const QScopedValueRollback shows(m_shows, true);
    if (!m_gesture.isOpen())
        m_gesture = m_editor.begin(tr("Text"));
    const PaintingPtr before = m_editor.document().painting();
    m_gesture.show(std::move(edit));
    const bool wasThere = std::exchange(m_isThere, bool(textOf(*m_editor.document().painting(), m_group)));
    if (wasThere && !m_isThere)
        m_emptied = {before, m_shown};
    m_shown = std::move(shown);
    if (m_preedit.isEmpty())
        m_plain = m_editor.document().painting();
}

/// Puts a text back that has no letter any more, so that what is typed now takes the place and the values of its
/// letters.
void TextEntry::bringBack()
{
    const Emptied was = *m_emptied;
    m_laid = m_layout.lay(was.text);
    put(restorePainting(m_editor.document(), *was.painting), was.text);
}

void TextEntry::show(std::optional<qsizetype> at)
{
    Text shown = m_text;
    shown.string.insert(m_caret, m_preedit);
    if (shown != m_shown) {
        LaidText laid = m_layout.lay(shown);
        if (!m_isThere && m_emptied && std::ranges::any_of(laid.clusters, &LaidCluster::hasInk))
            bringBack();
        TextChange change;
        change.at = at;
        change.letter = letterWith(m_editor.brush(), shown.size * scaleOf(shown.place), m_editor.clock().time());
        change.likeNeighbours = !m_usesBrush;
        Edit edit = setText(m_editor.document(), m_group, shown, &m_laid, laid, change);
        if (!m_isThere)
            edit = m_editor.layer().take(std::move(edit));
        m_editor.noteComing(edit);
        m_laid = std::move(laid);
        put(std::move(edit), std::move(shown));
    }
    emit changed();
}

void TextEntry::follow(const Change &change)
{
    if (!m_isOpen || m_shows)
        return;
    if (change.strokes.empty() && !change.order && !change.canvas && !change.texts && !change.reset)
        return;
    m_emptied.reset();
    m_past.clear(); // They would take back what somebody else has changed, too.
    m_future.clear();
    const PaintingPtr painting = m_editor.unsettled().painting();
    const SharedText text = textOf(*painting, m_group);
    // Its making was undone, it was deleted, made plain or locked.
    if (change.reset || (m_isThere && !text) || isTextLocked(*painting, m_group)) {
        close();
        return;
    }
    const bool isShown = !text || *text == m_shown;
    m_plain = isShown && !m_preedit.isEmpty() ? nullptr : painting;
    if (isShown)
        return;
    m_isThere = true;
    m_preedit.clear();
    if (const std::optional<qsizetype> end = endOfChange(m_text.string, text->string))
        m_caret = m_anchor = *end;
    m_text = m_shown = *text;
    m_laid = m_layout.lay(m_shown);
    emit changed();
}

} // namespace suffuse
