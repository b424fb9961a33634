<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Commands</name>
    <message numerus="yes">
        <source>%Ln segment(s) deleted; Undo brings back.</source>
        <translation>
            <numerusform>%Ln segment deleted; Undo brings it back.</numerusform>
            <numerusform>%Ln segments deleted; Undo brings them back.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln stroke(s); Undo takes it back.</source>
        <translation>
            <numerusform>%1: %Ln stroke; Undo takes it back.</numerusform>
            <numerusform>%1: %Ln strokes; Undo takes it back.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) deleted; Undo brings back.</source>
        <translation>
            <numerusform>%Ln stroke deleted; Undo brings it back.</numerusform>
            <numerusform>%Ln strokes deleted; Undo brings them back.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) now. Where their paint meets it mixes, and no longer adds up.</source>
        <translation>
            <numerusform>%Ln stroke now. Where its paint meets other paint it mixes, and no longer adds up.</numerusform>
            <numerusform>%Ln strokes now. Where their paint meets it mixes, and no longer adds up.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) selected. Delete once more deletes.</source>
        <translation>
            <numerusform>%Ln stroke selected. Delete once more deletes.</numerusform>
            <numerusform>%Ln strokes selected. Delete once more deletes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s) selected. Delete once more deletes.</source>
        <translation>
            <numerusform>%Ln segment selected. Delete once more deletes.</numerusform>
            <numerusform>%Ln segments selected. Delete once more deletes.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Cli</name>
    <message numerus="yes">
        <source>%n group(s) would look otherwise in other programs; their layers show what they make of the picture instead</source>
        <translation>
            <numerusform>%n group would look otherwise in other programs; its layer shows what it makes of the picture instead</numerusform>
            <numerusform>%n groups would look otherwise in other programs; their layers show what they make of the picture instead</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>%n s left</numerusform>
            <numerusform>%n s left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: none of its %n stroke(s) is whole; open a backup of it</source>
        <translation>
            <numerusform>%1: its one stroke is not whole; open a backup of it</numerusform>
            <numerusform>%1: none of its %n strokes is whole; open a backup of it</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) added</source>
        <translation>
            <numerusform>%n stroke added</numerusform>
            <numerusform>%n strokes added</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>  %n segment(s) with a share below %1 left out (--all)
</source>
        <translation>
            <numerusform>  %n segment with a share below %1 left out (--all)
</numerusform>
            <numerusform>  %n segments with a share below %1 left out (--all)
</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s)</source>
        <translation>
            <numerusform>%n stroke</numerusform>
            <numerusform>%n strokes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) that lay between them lie below now.</source>
        <translation>
            <numerusform>%n stroke that lay between them lies below now.</numerusform>
            <numerusform>%n strokes that lay between them lie below now.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 pieces of %n painting(s)</source>
        <translation>
            <numerusform>%1: %2 pieces of %n painting</numerusform>
            <numerusform>%1: %2 pieces of %n paintings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more file(s) are missing or damaged; farm verify --json names all.</source>
        <translation>
            <numerusform>%n more file is missing or damaged; farm verify --json names all.</numerusform>
            <numerusform>%n more files are missing or damaged; farm verify --json names all.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n line(s) of this journal are damaged, so nobody knows what was finished. Run the tasks again: they draw what is missing.</source>
        <translation>
            <numerusform>%1: %n line of this journal is damaged, so nobody knows what was finished. Run the tasks again: they draw what is missing.</numerusform>
            <numerusform>%1: %n lines of this journal are damaged, so nobody knows what was finished. Run the tasks again: they draw what is missing.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Clipboard</name>
    <message numerus="yes">
        <source>%Ln stroke(s) cannot lie there, too far out, and were left out.</source>
        <translation>
            <numerusform>%Ln stroke cannot lie there, too far out, and was left out.</numerusform>
            <numerusform>%Ln strokes cannot lie there, too far out, and were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>As SVG, for other programs, what was erased softly is left out: %n erasure(s).</source>
        <translation>
            <numerusform>As SVG, for other programs, what was erased softly is left out: %n erasure.</numerusform>
            <numerusform>As SVG, for other programs, what was erased softly is left out: %n erasures.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>SVG has no groups that mask, erase or clip what lies below: %n group(s) became plain.</source>
        <translation>
            <numerusform>SVG has no groups that mask, erase or clip what lies below: %n group became plain.</numerusform>
            <numerusform>SVG has no groups that mask, erase or clip what lies below: %n groups became plain.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>SVG has no washes: the strokes of %n group(s) lie over each other there.</source>
        <translation>
            <numerusform>SVG has no washes: the strokes of %n group lie over each other there.</numerusform>
            <numerusform>SVG has no washes: the strokes of %n groups lie over each other there.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>As SVG, for other programs, pictures are left out: %n of them.</source>
        <translation>
            <numerusform>As SVG, for other programs, a picture is left out.</numerusform>
            <numerusform>As SVG, for other programs, %n pictures are left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Renderer</name>
    <message numerus="yes">
        <source>%n threads</source>
        <translation>
            <numerusform>%n thread</numerusform>
            <numerusform>%n threads</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::AlongDialog</name>
    <message numerus="yes">
        <source>%n stroke(s)</source>
        <translation>
            <numerusform>%n stroke</numerusform>
            <numerusform>%n strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::ColourTarget</name>
    <message numerus="yes">
        <source>Colours of %Ln segment(s)</source>
        <translation>
            <numerusform>Colours of %Ln segment</numerusform>
            <numerusform>Colours of %Ln segments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour of %Ln segment(s)</source>
        <translation>
            <numerusform>Colour of %Ln segment</numerusform>
            <numerusform>Colour of %Ln segments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colours of %Ln stroke(s)</source>
        <translation>
            <numerusform>Colours of %Ln stroke</numerusform>
            <numerusform>Colours of %Ln strokes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour of %Ln stroke(s)</source>
        <translation>
            <numerusform>Colour of %Ln stroke</numerusform>
            <numerusform>Colour of %Ln strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::Commands</name>
    <message numerus="yes">
        <source>Name of %Ln stroke(s)</source>
        <translation>
            <numerusform>Name of %Ln stroke</numerusform>
            <numerusform>Name of %Ln strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::Files</name>
    <message numerus="yes">
        <source>%n adjustment or fill layer(s)</source>
        <translation>
            <numerusform>%n adjustment or fill layer</numerusform>
            <numerusform>%n adjustment or fill layers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the effects of %n layer(s)</source>
        <translation>
            <numerusform>the effects of %n layer</numerusform>
            <numerusform>the effects of %n layers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the mask(s) of %n group(s)</source>
        <translation>
            <numerusform>the mask of %n group</numerusform>
            <numerusform>the masks of %n groups</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n layer(s) whose picture is missing, damaged or too large</source>
        <translation>
            <numerusform>%n layer whose picture is missing, damaged or too large</numerusform>
            <numerusform>%n layers whose picture is missing, damaged or too large</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the mode(s) of %n layer(s)</source>
        <translation>
            <numerusform>the mode of %n layer</numerusform>
            <numerusform>the modes of %n layers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n element(s) not drawn freehand</source>
        <translation>
            <numerusform>%n element not drawn freehand</numerusform>
            <numerusform>%n elements not drawn freehand</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n brush shape(s)</source>
        <translation>
            <numerusform>%n brush shape</numerusform>
            <numerusform>%n brush shapes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turned or stretched brush tip(s)</source>
        <translation>
            <numerusform>%n turned or stretched brush tip</numerusform>
            <numerusform>%n turned or stretched brush tips</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n view(s) of recognised text</source>
        <translation>
            <numerusform>%n view of recognised text</numerusform>
            <numerusform>%n views of recognised text</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 were left out.</source>
        <extracomment>%1: a list such as &quot;3 fills, 2 gradients&quot;; the number is that of all things in it.</extracomment>
        <translation>
            <numerusform>%1 was left out.</numerusform>
            <numerusform>%1 were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n gradient(s)</source>
        <translation>
            <numerusform>%n gradient</numerusform>
            <numerusform>%n gradients</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pattern(s)</source>
        <translation>
            <numerusform>%n pattern</numerusform>
            <numerusform>%n patterns</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n clip path(s)</source>
        <translation>
            <numerusform>%n clip path</numerusform>
            <numerusform>%n clip paths</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mask(s)</source>
        <translation>
            <numerusform>%n mask</numerusform>
            <numerusform>%n masks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n filter(s)</source>
        <translation>
            <numerusform>%n filter</numerusform>
            <numerusform>%n filters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n blend mode(s)</source>
        <translation>
            <numerusform>%n blend mode</numerusform>
            <numerusform>%n blend modes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marker(s)</source>
        <translation>
            <numerusform>%n marker</numerusform>
            <numerusform>%n markers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n intricate outline(s)</source>
        <translation>
            <numerusform>%n intricate outline</numerusform>
            <numerusform>%n intricate outlines</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s)</source>
        <translation>
            <numerusform>%n text</numerusform>
            <numerusform>%n texts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n image(s)</source>
        <translation>
            <numerusform>%n image</numerusform>
            <numerusform>%n images</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n style rule(s)</source>
        <translation>
            <numerusform>%n style rule</numerusform>
            <numerusform>%n style rules</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n &lt;use&gt; of itself</source>
        <translation>
            <numerusform>%n &lt;use&gt; of itself</numerusform>
            <numerusform>%n &lt;use&gt; of themselves</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fill(s)</source>
        <translation>
            <numerusform>%n fill</numerusform>
            <numerusform>%n fills</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) came in as letters: they cannot be typed in again.</source>
        <translation>
            <numerusform>%n text came in as letters: it cannot be typed in again.</numerusform>
            <numerusform>%n texts came in as letters: they cannot be typed in again.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the images of %n image layer(s) are missing</source>
        <translation>
            <numerusform>the image of an image layer is missing</numerusform>
            <numerusform>the images of %n image layers are missing</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>So it is with %n other picture(s).</source>
        <translation>
            <numerusform>So it is with another picture.</numerusform>
            <numerusform>So it is with %n other pictures.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line style(s)</source>
        <translation>
            <numerusform>%n line style</numerusform>
            <numerusform>%n line styles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n shape(s)</source>
        <translation>
            <numerusform>%n shape</numerusform>
            <numerusform>%n shapes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n way(s) of the pen over the paper</source>
        <translation>
            <numerusform>%n way of the pen over the paper</numerusform>
            <numerusform>%n ways of the pen over the paper</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mapping(s) of channels</source>
        <translation>
            <numerusform>%n mapping of channels</numerusform>
            <numerusform>%n mappings of channels</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) of sound</source>
        <translation>
            <numerusform>%n recording of sound</numerusform>
            <numerusform>%n recordings of sound</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n ruled or printed paper(s)</source>
        <translation>
            <numerusform>%n ruled or printed paper</numerusform>
            <numerusform>%n ruled or printed papers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %n painting(s) in this PDF file the first one was opened.</source>
        <translation>
            <numerusform>Of %n painting in this PDF file the first one was opened.</numerusform>
            <numerusform>Of %n paintings in this PDF file the first one was opened.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::InspectorPanel</name>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln stroke</numerusform>
            <numerusform>%Ln strokes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln segment</numerusform>
            <numerusform>%Ln segments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %Ln segment(s)</source>
        <translation>
            <numerusform>%1 of %Ln segment</numerusform>
            <numerusform>%1 of %Ln segments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln erasing segment(s)</source>
        <translation>
            <numerusform>%Ln erasing segment</numerusform>
            <numerusform>%Ln erasing segments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln of them take(s) paint away.</source>
        <translation>
            <numerusform>%Ln of them takes paint away.</numerusform>
            <numerusform>%Ln of them take paint away.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::KnifeTool</name>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln stroke</numerusform>
            <numerusform>%Ln strokes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln part(s)</source>
        <translation>
            <numerusform>%Ln part</numerusform>
            <numerusform>%Ln parts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln node(s)</source>
        <translation>
            <numerusform>%Ln node</numerusform>
            <numerusform>%Ln nodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <comment>in</comment>
        <translation>
            <numerusform>%Ln stroke</numerusform>
            <numerusform>%Ln strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::RecolourDialog</name>
    <message numerus="yes">
        <source>%n colours that look alike</source>
        <translation>
            <numerusform>%n colour that looks alike</numerusform>
            <numerusform>%n colours that look alike</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::RecoveryDialog</name>
    <message numerus="yes">
        <source>Discard %n paintings?</source>
        <translation>
            <numerusform>Discard %n painting?</numerusform>
            <numerusform>Discard %n paintings?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesModel</name>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln segment</numerusform>
            <numerusform>%Ln segments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln piece(s)</source>
        <translation>
            <numerusform>%Ln piece</numerusform>
            <numerusform>%Ln pieces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln erasure(s)</source>
        <translation>
            <numerusform>%Ln erasure</numerusform>
            <numerusform>%Ln erasures</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::TimelapseDialog</name>
    <message numerus="yes">
        <source>%1; %n second(s) left</source>
        <translation>
            <numerusform>%1; %n second left</numerusform>
            <numerusform>%1; %n seconds left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n minute(s) left</source>
        <translation>
            <numerusform>%1; %n minute left</numerusform>
            <numerusform>%1; %n minutes left</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::ValueCard</name>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln stroke</numerusform>
            <numerusform>%Ln strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::PictureSection</name>
    <message numerus="yes">
        <source>%n picture(s)</source>
        <translation>
            <numerusform>%n picture</numerusform>
            <numerusform>%n pictures</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message numerus="yes">
        <source>SVG has no groups that erase what lies below: %n group(s) became plain.</source>
        <translation>
            <numerusform>SVG has no groups that erase what lies below: %n group became plain.</numerusform>
            <numerusform>SVG has no groups that erase what lies below: %n groups became plain.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) are left out, since nothing of them is covered enough to have a path.</source>
        <translation>
            <numerusform>%n stroke is left out, since nothing of it is covered enough to have a path.</numerusform>
            <numerusform>%n strokes are left out, since nothing of them is covered enough to have a path.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>PDF has no groups that erase what lies below, or add to it: %n group(s) became plain.</source>
        <translation>
            <numerusform>PDF has no groups that erase what lies below, or add to it: %n group became plain.</numerusform>
            <numerusform>PDF has no groups that erase what lies below, or add to it: %n groups became plain.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesView</name>
    <message numerus="yes">
        <source>%Ln row(s)</source>
        <translation>
            <numerusform>%Ln row</numerusform>
            <numerusform>%Ln rows</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::FitDialog</name>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln stroke</numerusform>
            <numerusform>%Ln strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RefitTask</name>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln stroke</numerusform>
            <numerusform>%Ln strokes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in place of %Ln.</source>
        <translation>
            <numerusform>in place of %Ln.</numerusform>
            <numerusform>in place of %Ln.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) that lay between them lie below now.</source>
        <translation>
            <numerusform>%Ln stroke that lay between them lies below now.</numerusform>
            <numerusform>%Ln strokes that lay between them lie below now.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FitLayer</name>
    <message numerus="yes">
        <source>%Ln stroke(s) came in, and a ground below them.</source>
        <translation>
            <numerusform>%Ln stroke came in, and a ground below it.</numerusform>
            <numerusform>%Ln strokes came in, and a ground below them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::Extensions</name>
    <message numerus="yes">
        <source>It was ended after %n second(s), which is as long as it may take.</source>
        <translation>
            <numerusform>It was ended after %n second, which is as long as it may take.</numerusform>
            <numerusform>It was ended after %n seconds, which is as long as it may take.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StrokeWords</name>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>%Ln segment</numerusform>
            <numerusform>%Ln segments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln stroke</numerusform>
            <numerusform>%Ln strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasReading</name>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln stroke</numerusform>
            <numerusform>%Ln strokes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln selected</source>
        <translation>
            <numerusform>%Ln selected</numerusform>
            <numerusform>%Ln selected</numerusform>
        </translation>
    </message>
</context>
</TS>
