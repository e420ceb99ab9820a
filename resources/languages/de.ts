<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
 <context>
  <name>procc</name>
  <message>
   <source>the principal point is far from the centre of the picture, which seems cut out of a larger one</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>der Bildhauptpunkt liegt weit von der Bildmitte, das Bild scheint aus einem größeren ausgeschnitten</translation>
  </message>
  <message>
   <source>with aspect ratio and principal point {px} px: not clearly better</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>mit Seitenverhältnis und Bildhauptpunkt {px} px: nicht deutlich besser</translation>
  </message>
  <message>
   <source>coordinates look like pixels, expected 0 to 1 (x = {x:g}, y = {y:g})</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>Koordinaten sehen nach Pixeln aus, erwartet ist 0 bis 1 (x = {x:g}, y = {y:g})</translation>
  </message>
  <message>
   <source>without lens distortion the points are {without} px off, with it {with_it} px: not clearly better</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>ohne Linsenverzeichnung liegen die Punkte {without} px daneben, mit ihr {with_it} px: nicht deutlich besser</translation>
  </message>
  <message>
   <source>aspect ratio and principal point bring the points from {before} to {after} px, more than three parameters would by chance</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>Seitenverhältnis und Bildhauptpunkt bringen die Punkte von {before} auf {after} px, mehr als drei Parameter zufällig brächten</translation>
  </message>
  <message>
   <source>lens distortion brings the points from {before} to {after} px</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>die Linsenverzeichnung bringt die Punkte von {before} auf {after} px</translation>
  </message>
  <message>
   <source>the points show lens distortion clearly and are {px} px off</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>die Punkte zeigen deutliche Linsenverzeichnung und liegen {px} px daneben</translation>
  </message>
  <message>
   <source>even with the position known: {why}</source>
   <extracomment>[procc_annotator/calibration/joint/shared_position.py]</extracomment>
   <translation>selbst mit bekannter Position: {why}</translation>
  </message>
  <message>
   <source>{count} positions, and nothing tells which is its</source>
   <extracomment>[procc_annotator/calibration/joint/shared_position.py]</extracomment>
   <translation>{count} Positionen, und nichts sagt, welche die seine ist</translation>
  </message>
  <message>
   <source>all labels fit with far and near exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>alle Klassen passen, wenn fern und nah vertauscht sind</translation>
  </message>
  <message>
   <source>all labels fit with left and right exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>alle Klassen passen, wenn links und rechts vertauscht sind</translation>
  </message>
  <message>
   <source>elements are {after:.1f} px off on average, {before:.1f} px as they are</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>Elemente liegen im Mittel {after:.1f} px daneben, so wie sie sind {before:.1f} px</translation>
  </message>
  <message>
   <source>two points are exchanged: the one of {some} and the one of {others}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>zwei Punkte sind vertauscht: der von {some} und der von {others}</translation>
  </message>
  <message>
   <source>elements are {after:.1f} px off on average, no camera fits the labels as they are</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>Elemente liegen im Mittel {after:.1f} px daneben; so, wie sie sind, passt keine Kamera</translation>
  </message>
  <message>
   <source>{a} and {b} fit with each other's label</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{a} und {b} passen mit der Klasse des jeweils anderen</translation>
  </message>
  <message>
   <source>{titles} fit with each other's labels</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{titles} passen mit den Klassen der jeweils anderen</translation>
  </message>
  <message>
   <source>relabel {steps}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>umbenennen: {steps}</translation>
  </message>
  <message>
   <source>{title} is up to {px:.0f} px from where the camera of the others shows it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} liegt bis zu {px:.0f} px von dort, wo die Kamera der anderen es zeigt</translation>
  </message>
  <message>
   <source>{title} is nowhere near where the camera of the others shows it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} liegt weit weg von dort, wo die Kamera der anderen es zeigt</translation>
  </message>
  <message>
   <source>without {titles} the others drop from {before:.1f} to {after:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>ohne {titles} fallen die anderen von {before:.1f} auf {after:.1f} px</translation>
  </message>
  <message>
   <source>swap {a} and {b}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py, procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{a} und {b} tauschen</translation>
  </message>
  <message>
   <source>{a} to {b}</source>
   <comment>labels</comment>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{a} in {b}</translation>
  </message>
  <message>
   <source>it lies where {title} should be</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>es liegt, wo {title} sein müsste</translation>
  </message>
  <message>
   <source>the others are {px:.1f} px off with and without it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>die anderen liegen mit und ohne es {px:.1f} px daneben</translation>
  </message>
  <message>
   <source>more than its own place is uncertain</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>mehr, als sein eigener Ort unsicher ist</translation>
  </message>
  <message>
   <source>relabel to {title}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py, procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>in {title} umbenennen</translation>
  </message>
  <message>
   <source>it lies on {title}, which is annotated as well</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>es liegt auf {title}, das ebenfalls annotiert ist</translation>
  </message>
  <message>
   <source>{title} is up to {px:.0f} px from where the camera shows it; too few elements fit to say which are wrong</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} liegt bis zu {px:.0f} px von dort, wo die Kamera es zeigt; zu wenige Elemente passen, um zu sagen, welche falsch sind</translation>
  </message>
  <message>
   <source>no camera fits these labels together</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>keine Kamera passt zu diesen Klassen zusammen</translation>
  </message>
  <message>
   <source>exchange far and near in the whole frame</source>
   <extracomment>[procc_annotator/calibration/label_check/candidate_classes.py]</extracomment>
   <translation>fern und nah im ganzen Bild tauschen</translation>
  </message>
  <message>
   <source>exchange left and right in the whole frame</source>
   <extracomment>[procc_annotator/calibration/label_check/candidate_classes.py]</extracomment>
   <translation>links und rechts im ganzen Bild tauschen</translation>
  </message>
  <message>
   <source>turn the labels by half a turn</source>
   <extracomment>[procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>die Klassen um eine halbe Drehung drehen</translation>
  </message>
  <message numerus="yes">
   <source>the camera stands on a side of the field where hardly any other of {n} frames does: a camera of its own, or labels turned by half a turn</source>
   <extracomment>the camera stands on a side of the field where hardly any other of {n} frame does: a camera of its own, or labels turned by half a turn / the camera stands on a side of the field where hardly any other of {n} frames does: a camera of its own, or labels turned by half a turn [procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>
    <numerusform>die Kamera steht auf einer Seite des Feldes, auf der kaum eine andere von {n} Bild steht: eine eigene Kamera, oder um eine halbe Drehung gedrehte Klassen</numerusform>
    <numerusform>die Kamera steht auf einer Seite des Feldes, auf der kaum eine andere von {n} Bildern steht: eine eigene Kamera, oder um eine halbe Drehung gedrehte Klassen</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frames does</source>
   <extracomment>the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frame does / the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frames does [procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>
    <numerusform>die Kamera steht auf der anderen Seite des Feldes als die übrigen; mit um eine halbe Drehung gedrehten Klassen steht sie, wo die von {n} Bild steht</numerusform>
    <numerusform>die Kamera steht auf der anderen Seite des Feldes als die übrigen; mit um eine halbe Drehung gedrehten Klassen steht sie, wo die von {n} Bildern stehen</numerusform>
   </translation>
  </message>
  <message>
   <source>no such class: {name!r}, did you mean {title}?</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>keine solche Klasse: {name!r}, ist {title} gemeint?</translation>
  </message>
  <message>
   <source>{title} is straight on the field, its points lie up to {px:.0f} px beside a line, more than any lens bends it</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{title} ist auf dem Feld gerade, seine Punkte liegen bis zu {px:.0f} px neben einer Geraden, mehr als ein Objektiv sie biegt</translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points, a line takes two</source>
   <extracomment>{title} has {n} point, a line takes two / {title} has {n} points, a line takes two [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} hat {n} Punkt, eine Linie braucht zwei</numerusform>
    <numerusform>{title} hat {n} Punkte, eine Linie braucht zwei</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points; a curve takes at least {least}</source>
   <extracomment>{title} has {n} point; a curve takes at least {least} / {title} has {n} points; a curve takes at least {least} [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} hat {n} Punkt; eine Kurve braucht mindestens {least}</numerusform>
    <numerusform>{title} hat {n} Punkte; eine Kurve braucht mindestens {least}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points: {least} points needed for a curve</source>
   <extracomment>{title} has {n} point: {least} points needed for a curve / {title} has {n} points: {least} points needed for a curve [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} hat {n} Punkt: eine Kurve braucht {least}</numerusform>
    <numerusform>{title} hat {n} Punkte: eine Kurve braucht {least}</numerusform>
   </translation>
  </message>
  <message>
   <source>{title} is a single place, it has {count} points up to {px:.0f} px apart</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{title} ist ein einzelner Ort, hat aber {count} Punkte, die bis zu {px:.0f} px auseinanderliegen</translation>
  </message>
  <message>
   <source>the points of {title} go back and forth instead of along it</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>die Punkte von {title} gehen hin und her statt daran entlang</translation>
  </message>
  <message>
   <source>no such class: {name!r} fits no camera, and counts as missed where it is scored</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>keine solche Klasse: {name!r} passt zu keiner Kamera und zählt als verfehlt, wo bewertet wird</translation>
  </message>
  <message>
   <source>{a} and {b} lie on top of each other, less than {px:.0f} px apart: one line under two names?</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{a} und {b} liegen aufeinander, weniger als {px:.0f} px auseinander: eine Linie unter zwei Namen?</translation>
  </message>
  <message>
   <source>remove point {number}</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py, procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>Punkt {number} entfernen</translation>
  </message>
  <message>
   <source>look at point {number}</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py, procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>Punkt {number} ansehen</translation>
  </message>
  <message>
   <source>the points of {title} go over the same stretch more than once: their course is {times:.1f} times as long as it need be</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>die Punkte von {title} gehen mehrmals über denselben Abschnitt: ihr Weg ist {times:.1f}-mal so lang wie nötig</translation>
  </message>
  <message>
   <source>That is annotated already</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>Das ist schon annotiert</translation>
  </message>
  <message>
   <source>its corner</source>
   <comment>where a line ends</comment>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>seiner Ecke</translation>
  </message>
  <message>
   <source>the picture's edge</source>
   <comment>where a line ends</comment>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>dem Bildrand</translation>
  </message>
  <message>
   <source>move its points onto the line</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>seine Punkte auf die Linie setzen</translation>
  </message>
  <message>
   <source>{title} bends: its line is up to {px:.0f} px off between points. Press R to follow it</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{title} ist gebogen: zwischen den Punkten liegt die Linie bis zu {px:.0f} px daneben. R lässt die Punkte ihr folgen</translation>
  </message>
  <message>
   <source>one end of {title} is {px:.0f} px off the line. Move it onto the paint</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>ein Ende von {title} liegt {px:.0f} px neben der Linie. Setzen Sie es auf die Farbe</translation>
  </message>
  <message>
   <source>{percent:.0f} % of {title} is not on paint (longest gap {px:.0f} px). Line bends? Press R</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{percent:.0f} % von {title} liegen nicht auf Farbe (längste Lücke {px:.0f} px). Linie gebogen? R drücken</translation>
  </message>
  <message>
   <source>one end of {title} is not on paint</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>ein Ende von {title} liegt nicht auf Farbe</translation>
  </message>
  <message>
   <source>{title} stops {px:.0f} px short of {what}</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{title} endet {px:.0f} px vor {what}</translation>
  </message>
  <message>
   <source>look at it</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>ansehen</translation>
  </message>
  <message>
   <source>point {number} of {title} is {off:.0f} px off, its other points at most {rest:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>Punkt {number} von {title} liegt {off:.0f} px daneben, die anderen Punkte höchstens {rest:.1f} px</translation>
  </message>
  <message>
   <source>point {number} of {title} is {off:.0f} px off, its other point at most {rest:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>Punkt {number} von {title} liegt {off:.0f} px daneben, der andere Punkt höchstens {rest:.1f} px</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: far and near, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>alles liegt verkehrt herum: fern und nah sind vertauscht</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: left and right, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>alles liegt verkehrt herum: links und rechts sind vertauscht</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: far and near, or left and right, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>alles liegt verkehrt herum: fern und nah, oder links und rechts, sind vertauscht</translation>
  </message>
  <message>
   <source>{title} is on the wrong side of {others}</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{title} liegt auf der falschen Seite von {others}</translation>
  </message>
  <message>
   <source>{titles} lie on each other's side of the elements around them</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{titles} liegen auf der Seite des jeweils anderen</translation>
  </message>
  <message>
   <source>{titles} cannot lie this way round to each other, whatever the camera</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{titles} können nicht so herum zueinander liegen, gleich bei welcher Kamera</translation>
  </message>
  <message>
   <source>only {share:.0%} of the lines in sight are on paint</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py, procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>nur {share:.0%} der sichtbaren Linien liegen auf Farbe</translation>
  </message>
  <message>
   <source>there is too little paint</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py]</extracomment>
   <translation>es gibt zu wenig Farbe</translation>
  </message>
  <message>
   <source>the paint nearby would take a peg from its place</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py]</extracomment>
   <translation>die Farbe in der Nähe nähme einem Pflock seinen Platz</translation>
  </message>
  <message>
   <source>{name} is {px:.0f} px off its line, and {more} more are off theirs</source>
   <extracomment>[procc_annotator/calibration/line_alignment/refinement.py]</extracomment>
   <translation>{name} liegt {px:.0f} px neben seiner Linie, {more} weitere ebenso</translation>
  </message>
  <message>
   <source>{name} is {px:.0f} px off its line</source>
   <extracomment>[procc_annotator/calibration/line_alignment/refinement.py]</extracomment>
   <translation>{name} liegt {px:.0f} px neben seiner Linie</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements, {needed} needed</source>
   <extracomment>{n} element, {needed} needed / {n} elements, {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>{n} Element, {needed} nötig</numerusform>
    <numerusform>{n} Elemente, {needed} nötig</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{points} points on {n} elements, two different ones on each of {needed} needed</source>
   <extracomment>{points} points on {n} element, two different ones on each of {needed} needed / {points} points on {n} elements, two different ones on each of {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>{points} Punkte auf {n} Element, nötig sind je zwei verschiedene auf {needed}</numerusform>
    <numerusform>{points} Punkte auf {n} Elementen, nötig sind je zwei verschiedene auf {needed}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n} elements on the ground, {needed} needed</source>
   <extracomment>{n} element on the ground, {needed} needed / {n} elements on the ground, {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>{n} Element am Boden, {needed} nötig</numerusform>
    <numerusform>{n} Elemente am Boden, {needed} nötig</numerusform>
   </translation>
  </message>
  <message>
   <source>all points lie in one place of the picture</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>alle Punkte liegen an einer Stelle des Bildes</translation>
  </message>
  <message>
   <source>all points lie on one line of the picture</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>alle Punkte liegen auf einer Linie des Bildes</translation>
  </message>
  <message>
   <source>not a plausible pose: the fit did not settle</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>keine plausible Pose: die Anpassung kam nicht zur Ruhe</translation>
  </message>
  <message>
   <source>not a plausible pose: on the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>keine plausible Pose: auf dem Boden</translation>
  </message>
  <message>
   <source>not a plausible pose: {metres:.1f} m below the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>keine plausible Pose: {metres:.1f} m unter dem Boden</translation>
  </message>
  <message>
   <source>not a plausible pose: only {metres:.1f} m above the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>keine plausible Pose: nur {metres:.1f} m über dem Boden</translation>
  </message>
  <message>
   <source>not a plausible pose: {metres:.0f} m from the field's centre</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>keine plausible Pose: {metres:.0f} m von der Feldmitte</translation>
  </message>
  <message>
   <source>not a plausible pose: rolled by {degrees:.0f} degrees</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>keine plausible Pose: um {degrees:.0f} Grad gerollt</translation>
  </message>
  <message>
   <source>not a plausible pose: focal length {px:.0f} px at 960 px width</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>keine plausible Pose: Brennweite {px:.0f} px bei 960 px Breite</translation>
  </message>
  <message>
   <source>pan, tilt or roll ± more than {degrees:g}°, position ± more than {way:g} % of the way to the field's centre, or focal length ± more than {focal:g} %, or clicks that are the same from the other end</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>Schwenk, Neigung oder Rollen ± mehr als {degrees:g}°, Position ± mehr als {way:g} % des Wegs zur Feldmitte, oder Brennweite ± mehr als {focal:g} %, oder Klicks, die vom anderen Ende gleich sind</translation>
  </message>
  <message>
   <source>no camera explains these elements together: the best one misses half of them by more than {px:.0f} px (are the labels right?)</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>keine Kamera erklärt diese Elemente zusammen: die beste verfehlt die Hälfte davon um mehr als {px:.0f} px (sind die Klassen richtig?)</translation>
  </message>
  <message>
   <source>pan ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>Schwenk ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>tilt ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>Neigung ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>roll ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>Rollen ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>position ± {metres:.0f} m</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>Position ± {metres:.0f} m</translation>
  </message>
  <message>
   <source>focal length ± {percent:.0f} %</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>Brennweite ± {percent:.0f} %</translation>
  </message>
  <message>
   <source>the same from the other end</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>vom anderen Ende gleich</translation>
  </message>
  <message>
   <source>a different view fits almost as well</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>eine andere Ansicht passt fast ebenso gut</translation>
  </message>
  <message>
   <source>expected lines are missing</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>erwartete Linien fehlen</translation>
  </message>
  <message>
   <source>some lines in the picture do not match the field</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>manche Linien im Bild passen nicht zum Feld</translation>
  </message>
  <message>
   <source>too few lines in view</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>zu wenige Linien im Bild</translation>
  </message>
  <message>
   <source>unusual camera position</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>ungewöhnliche Kameraposition</translation>
  </message>
  <message>
   <source>the visible lines do not determine the camera</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>die sichtbaren Linien bestimmen die Kamera nicht</translation>
  </message>
  <message>
   <source>{lines:.0f} % of expected lines found, {paint:.0f} % of visible paint matched</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>{lines:.0f} % der erwarteten Linien gefunden, {paint:.0f} % der sichtbaren Farbe zugeordnet</translation>
  </message>
  <message>
   <source>is this {field}? {why}</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>ist dies {field}? {why}</translation>
  </message>
  <message>
   <source>no camera fits the lines (best: {shares})</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>keine Kamera passt zu den Linien (beste: {shares})</translation>
  </message>
  <message>
   <source>the picture is nearly square: its pixels may not be</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>das Bild ist fast quadratisch: seine Pixel sind es vielleicht nicht</translation>
  </message>
  <message>
   <source>{field} has no painted lines to look for</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>{field} hat keine gemalten Linien, die sich suchen ließen</translation>
  </message>
  <message>
   <source>no camera has its lines on the paint of this picture</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>keine Kamera hat ihre Linien auf der Farbe dieses Bildes</translation>
  </message>
  <message>
   <source>there is hardly any paint on the ground in this picture</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>in diesem Bild ist kaum Farbe auf dem Boden</translation>
  </message>
  <message>
   <source>too little paint in sight</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>zu wenig Farbe in Sicht</translation>
  </message>
  <message>
   <source>too little of what should be in sight was found</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>zu wenig davon gefunden, was zu sehen sein müsste</translation>
  </message>
  <message>
   <source>the paint that was found would move the camera too far</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>die gefundene Farbe würde die Kamera zu weit verschieben</translation>
  </message>
  <message>
   <source>the pixels may not be {aspect:.3f} times as wide as high ({percent:.0f} %)</source>
   <extracomment>[procc_annotator/calibration/tracking/shot_tracker.py]</extracomment>
   <translation>die Pixel sind vielleicht nicht {aspect:.3f}-mal so breit wie hoch ({percent:.0f} %)</translation>
  </message>
  <message>
   <source>the track is {px:.0f} px off the nearest frame whose camera was known</source>
   <extracomment>[procc_annotator/calibration/tracking/shot_tracker.py]</extracomment>
   <translation>die Spur liegt {px:.0f} px neben dem nächsten Bild, dessen Kamera bekannt war</translation>
  </message>
  <message>
   <source>{count} of {total} clicks lie where the camera shows nothing</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>{count} von {total} Klicks liegen, wo die Kamera nichts zeigt</translation>
  </message>
  <message>
   <source>the views look at it from nearly the same direction ({degrees:.2f} degrees apart, at least {least:g} are needed)</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>die Ansichten sehen es aus fast derselben Richtung ({degrees:.2f} Grad auseinander, nötig sind mindestens {least:g})</translation>
  </message>
  <message>
   <source>clicked in no view that has a camera</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>in keiner Ansicht geklickt, die eine Kamera hat</translation>
  </message>
  <message>
   <source>cameras that know only the ground (homographies) have no position in space</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>Kameras, die nur den Boden kennen (Homographien), bestimmen keinen Ort im Raum</translation>
  </message>
  <message>
   <source>the lines of sight meet behind the camera of {names}</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>die Sichtlinien treffen sich hinter der Kamera von {names}</translation>
  </message>
  <message>
   <source>clicked in one view only</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>nur in einer Ansicht geklickt</translation>
  </message>
  <message>
   <source>would be farther than {metres:g} m from the field</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>läge weiter als {metres:g} m vom Feld entfernt</translation>
  </message>
  <message>
   <source>the views do not agree: {far} px off (is it the same place in all of them, and are the cameras right?)</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>die Ansichten stimmen nicht überein: {far} px daneben (ist es in allen derselbe Ort, und sind die Kameras richtig?)</translation>
  </message>
  <message>
   <source>Fitted to the clicks of each frame; nothing of it is in a file</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>An die Klicks jedes Bildes angepasst; nichts davon ist in einer Datei</translation>
  </message>
  <message>
   <source>the paint is {px:.1f} px from the lines</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>die Farbe liegt {px:.1f} px neben den Linien</translation>
  </message>
  <message>
   <source>Followed through the shot; nothing of it is in a file</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>Durch die Einstellung verfolgt; nichts davon ist in einer Datei</translation>
  </message>
  <message>
   <source>no track here: {why}</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>hier keine Spur: {why}</translation>
  </message>
  <message>
   <source>no fit of {frame} yet</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>noch keine Anpassung von {frame}</translation>
  </message>
  <message>
   <source>no camera was found</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py, procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>keine Kamera wurde gefunden</translation>
  </message>
  <message>
   <source>carried over by the picture's motion, not measured on paint</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>durch die Bewegung des Bildes weitergeführt, nicht auf Farbe gemessen</translation>
  </message>
  <message>
   <source>not followed so far</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>bisher nicht verfolgt</translation>
  </message>
  <message>
   <source>{title} was surveyed: its position stays as it is</source>
   <extracomment>[procc_annotator/dataset/landmarks/clicks.py]</extracomment>
   <translation>{title} wurde vermessen: der Ort bleibt, wie er ist</translation>
  </message>
  <message>
   <source>{title} moves: its positions hold for an instant each</source>
   <extracomment>[procc_annotator/dataset/landmarks/clicks.py]</extracomment>
   <translation>{title} bewegt sich: seine Orte gelten je für einen Augenblick</translation>
  </message>
  <message>
   <source>its camera is hardly determined: {what}</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>seine Kamera ist kaum bestimmt: {what}</translation>
  </message>
  <message>
   <source>no camera in {frame} ({why}), and {count} more</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>keine Kamera in {frame} ({why}), und {count} weiteren</translation>
  </message>
  <message>
   <source>no camera in {frame} ({why})</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>keine Kamera in {frame} ({why})</translation>
  </message>
  <message>
   <source>surveyed: kept as it is</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>vermessen: bleibt, wie sie ist</translation>
  </message>
  <message>
   <source>untouched</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>unberührt</translation>
  </message>
  <message>
   <source>in progress</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>in Arbeit</translation>
  </message>
  <message>
   <source>done</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>fertig</translation>
  </message>
  <message>
   <source>approved</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>freigegeben</translation>
  </message>
  <message>
   <source>rejected</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>abgelehnt</translation>
  </message>
  <message>
   <source>clicked</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>geklickt</translation>
  </message>
  <message>
   <source>snapped</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>eingerastet</translation>
  </message>
  <message>
   <source>regularised</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>begradigt</translation>
  </message>
  <message>
   <source>copied</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>kopiert</translation>
  </message>
  <message>
   <source>moved</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>verschoben</translation>
  </message>
  <message>
   <source>accepted suggestion</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>angenommener Vorschlag der Anpassung</translation>
  </message>
  <message>
   <source>proposed</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>vorgeschlagen</translation>
  </message>
  <message>
   <source>accepted proposal</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>angenommener Vorschlag</translation>
  </message>
  <message>
   <source>unconfirmed by paint</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>nicht durch Farbe bestätigt</translation>
  </message>
  <message>
   <source>from the file</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>aus der Datei</translation>
  </message>
  <message>
   <source>camera</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>Kamera</translation>
  </message>
  <message>
   <source>annotation</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>Annotation</translation>
  </message>
  <message>
   <source>fine</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>in Ordnung</translation>
  </message>
  <message>
   <source>camera wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>Kamera falsch</translation>
  </message>
  <message>
   <source>labels wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>Annotation falsch</translation>
  </message>
  <message>
   <source>OK</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>OK</translation>
  </message>
  <message>
   <source>taken back</source>
   <extracomment>[procc_annotator/dataset/saving.py, procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>zurückgenommen</translation>
  </message>
  <message>
   <source>saved</source>
   <extracomment>[procc_annotator/dataset/saving.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>gespeichert</translation>
  </message>
  <message>
   <source>as it was found</source>
   <extracomment>[procc_annotator/dataset/saving.py, procc_annotator/dataset/workspace.py]</extracomment>
   <translation>wie vorgefunden</translation>
  </message>
  <message>
   <source>what was saved elsewhere</source>
   <extracomment>[procc_annotator/dataset/workspace.py]</extracomment>
   <translation>was anderswo gespeichert wurde</translation>
  </message>
  <message>
   <source>overwritten</source>
   <extracomment>[procc_annotator/dataset/workspace.py]</extracomment>
   <translation>überschrieben</translation>
  </message>
  <message>
   <source>fitted on these clicks</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>an diese Klicks angepasst</translation>
  </message>
  <message>
   <source>fitted to another version of these annotations</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>an eine andere Fassung dieser Annotationen angepasst</translation>
  </message>
  <message>
   <source>fitted on these clicks, or to another version of these annotations</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>an diese Klicks oder an eine andere Fassung dieser Annotationen angepasst</translation>
  </message>
  <message>
   <source>closer to these clicks than a prediction can be</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>näher an diesen Klicks, als es eine Vorhersage sein kann</translation>
  </message>
  <message>
   <source>by file type and content</source>
   <extracomment>[procc_annotator/formats/cameras/registry.py]</extracomment>
   <translation>nach Dateityp und Inhalt</translation>
  </message>
  <message>
   <source>File</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Datei</translation>
  </message>
  <message>
   <source>Edit</source>
   <extracomment>[procc_annotator/gui/actions.py, the action edit_mode, the menus]</extracomment>
   <translation>Bearbeiten</translation>
  </message>
  <message>
   <source>Frame</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/commands/view_grouping.py, procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Bild</translation>
  </message>
  <message>
   <source>Element</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/panels/agreement.py, procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Element</translation>
  </message>
  <message>
   <source>View</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/commands/view_grouping.py, the menus]</extracomment>
   <translation>Ansicht</translation>
  </message>
  <message>
   <source>Camera</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/command_palette.py, the menus]</extracomment>
   <translation>Kamera</translation>
  </message>
  <message>
   <source>Help</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Hilfe</translation>
  </message>
  <message>
   <source>The picture cannot be shown</source>
   <extracomment>[procc_annotator/gui/canvas/annotation_preview.py]</extracomment>
   <translation>Das Bild kann nicht gezeigt werden</translation>
  </message>
  <message>
   <source>no camera is known here that could be dragged</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>hier ist keine Kamera bekannt, die sich ziehen ließe</translation>
  </message>
  <message>
   <source>taken back: the camera is as before it was dragged</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>zurückgenommen: die Kamera ist wie vor dem Ziehen</translation>
  </message>
  <message>
   <source>overlays are hidden (Ctrl+H)</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>Überlagerungen sind ausgeblendet (Strg+H)</translation>
  </message>
  <message>
   <source>a homography cannot be turned: choose another model (panel Fit)</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>eine Homographie lässt sich nicht drehen: wählen Sie ein anderes Modell (Bereich Anpassung)</translation>
  </message>
  <message>
   <source>release leaves it here</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>Loslassen lässt es hier</translation>
  </message>
  <message>
   <source>Esc puts it back</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py, procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc legt es zurück</translation>
  </message>
  <message numerus="yes">
   <source>{n} pegs hold the camera</source>
   <extracomment>{n} peg holds the camera / {n} pegs hold the camera [procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>
    <numerusform>{n} Pflock hält die Kamera</numerusform>
    <numerusform>{n} Pflöcke halten die Kamera</numerusform>
   </translation>
  </message>
  <message>
   <source>CAMERA</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>KAMERA</translation>
  </message>
  <message numerus="yes">
   <source>peg taken away: {n} pegs left</source>
   <extracomment>peg taken away: {n} peg left / peg taken away: {n} pegs left [procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>
    <numerusform>Pflock weggenommen: {n} Pflock bleibt</numerusform>
    <numerusform>Pflock weggenommen: {n} Pflöcke bleiben</numerusform>
   </translation>
  </message>
  <message>
   <source>peg taken away: the camera is as it was found</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>Pflock weggenommen: die Kamera ist, wie sie gefunden wurde</translation>
  </message>
  <message>
   <source>peg</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>Pflock</translation>
  </message>
  <message>
   <source>press on a line of the wireframe</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>auf eine Linie des Drahtgitters drücken</translation>
  </message>
  <message>
   <source>drag moves this peg</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>Ziehen bewegt diesen Pflock</translation>
  </message>
  <message>
   <source>click takes it away</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>Klick nimmt ihn weg</translation>
  </message>
  <message>
   <source>drag a place of the wireframe to where it belongs</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>eine Stelle des Drahtgitters dorthin ziehen, wo sie hingehört</translation>
  </message>
  <message>
   <source>drag {title} to where it belongs: the camera follows</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>{title} dorthin ziehen, wo es hingehört: die Kamera folgt</translation>
  </message>
  <message>
   <source>Ctrl+Z takes it back</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>Strg+Z nimmt es zurück</translation>
  </message>
  <message>
   <source>Picture</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py, procc_annotator/gui/settings.py, procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>Bild</translation>
  </message>
  <message>
   <source>PAN</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>VERSCHIEBEN</translation>
  </message>
  <message>
   <source>drag moves the picture</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>Ziehen bewegt das Bild</translation>
  </message>
  <message>
   <source>Esc takes the tool again</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>Esc nimmt wieder das Werkzeug</translation>
  </message>
  <message>
   <source>load a second set of cameras to blink between two (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>laden Sie einen zweiten Kamerasatz, um zwischen beiden zu blinken (Strg+L)</translation>
  </message>
  <message>
   <source>crosshair: the arrows move it (Shift 0.1 px, Ctrl 10 px, Ctrl+Shift 100 px), Space clicks, Esc puts it away</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>Fadenkreuz: die Pfeiltasten bewegen es (Umschalt 0.1 px, Strg 10 px, Strg+Umschalt 100 px), Leertaste klickt, Esc legt es weg</translation>
  </message>
  <message>
   <source>point at a line first: with the mouse, or with the arrows</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>zeigen Sie zuerst auf eine Linie: mit der Maus oder mit den Pfeiltasten</translation>
  </message>
  <message>
   <source>there is no line here to put a point on</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>hier ist keine Linie, auf die ein Punkt passt</translation>
  </message>
  <message>
   <source>camera unreadable</source>
   <extracomment>[procc_annotator/gui/canvas/comparison.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Kamera unlesbar</translation>
  </message>
  <message>
   <source>no camera here</source>
   <extracomment>[procc_annotator/gui/canvas/comparison.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>hier keine Kamera</translation>
  </message>
  <message>
   <source>next: {title}</source>
   <extracomment>[procc_annotator/gui/canvas/drawing.py]</extracomment>
   <translation>als Nächstes: {title}</translation>
  </message>
  <message>
   <source>{title}  ±{sd:.1f} px  unsure</source>
   <extracomment>[procc_annotator/gui/canvas/drawing.py]</extracomment>
   <translation>{title}  ±{sd:.1f} px  unsicher</translation>
  </message>
  <message>
   <source>{title} has no points in this frame: choose the element to delete</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>{title} hat in diesem Bild keine Punkte: wählen Sie das zu löschende Element</translation>
  </message>
  <message>
   <source>choose the element to delete first: field map, list, or its key</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>wählen Sie zuerst das zu löschende Element: Feldkarte, Liste oder Taste</translation>
  </message>
  <message numerus="yes">
   <source>dropped {n} points of {title}</source>
   <extracomment>dropped {n} point of {title} / dropped {n} points of {title} [procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>
    <numerusform>{n} Punkt von {title} verworfen</numerusform>
    <numerusform>{n} Punkte von {title} verworfen</numerusform>
   </translation>
  </message>
  <message>
   <source>{titles}: changed elsewhere, look again first</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>{titles}: anderswo geändert, sehen Sie erst noch einmal hin</translation>
  </message>
  <message numerus="yes">
   <source>kept {n} clicks of {title} on {frame}, unfinished: choose it there to go on</source>
   <extracomment>kept {n} click of {title} on {frame}, unfinished: choose it there to go on / kept {n} clicks of {title} on {frame}, unfinished: choose it there to go on [procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>
    <numerusform>{n} Klick von {title} auf {frame} ist unfertig aufgehoben: dort wählen, um weiterzumachen</numerusform>
    <numerusform>{n} Klicks von {title} auf {frame} sind unfertig aufgehoben: dort wählen, um weiterzumachen</numerusform>
   </translation>
  </message>
  <message>
   <source>finished {title}</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>{title} beendet</translation>
  </message>
  <message>
   <source>How good the fitted camera is</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>Wie gut die angepasste Kamera ist</translation>
  </message>
  <message>
   <source>metres on the ground, 1 sd</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>Meter am Boden, 1 σ</translation>
  </message>
  <message>
   <source>How good the fitted camera ({model}) is</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>Wie gut die angepasste Kamera ({model}) ist</translation>
  </message>
  <message>
   <source>{metres:g} m, asked of offside technology</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>{metres:g} m, von Abseitstechnik verlangt</translation>
  </message>
  <message>
   <source>metres on the ground, 1 sd, median {median:.2f}</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>Meter am Boden, 1 σ, Median {median:.2f}</translation>
  </message>
  <message>
   <source>metres on the ground</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>Meter am Boden</translation>
  </message>
  <message>
   <source>{metres:g} m: {percent:.0f} % of the field in sight</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>{metres:g} m: {percent:.0f} % des sichtbaren Feldes</translation>
  </message>
  <message>
   <source>Blind: no camera is shown before Ctrl+Enter</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Blind: keine Kamera vor Strg+Eingabe</translation>
  </message>
  <message>
   <source>Blind mode, this frame is committed</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Blindmodus, dieses Bild ist abgegeben</translation>
  </message>
  <message numerus="yes">
   <source>{n} pegs</source>
   <extracomment>{n} peg / {n} pegs [procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>
    <numerusform>{n} Pflock</numerusform>
    <numerusform>{n} Pflöcke</numerusform>
   </translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}, made exact on paint: {share:.0%} of its lines</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Kamera gezogen, {pegs}, an der Farbe genau gemacht: {share:.0%} ihrer Linien</translation>
  </message>
  <message>
   <source>Camera found, unsure: {why}. Shift+Enter accepts, Delete rejects it</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Kamera gefunden, unsicher: {why}. Umschalt+Eingabe nimmt sie an, Entf lehnt sie ab</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}, not made exact: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Kamera gezogen, {pegs}, nicht genau gemacht: {why}</translation>
  </message>
  <message>
   <source>Drag to move the divider (arrow keys do it too)</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Ziehen verschiebt die Trennlinie (Pfeiltasten auch)</translation>
  </message>
  <message>
   <source>Divider of the split view</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Trennlinie der geteilten Ansicht</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Kamera gezogen, {pegs}</translation>
  </message>
  <message>
   <source>Camera of the track: Shift+Enter accepts its elements</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Kamera der Spur: Umschalt+Eingabe nimmt ihre Elemente an</translation>
  </message>
  <message>
   <source>Looking for the camera in the picture …</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Die Kamera wird im Bild gesucht …</translation>
  </message>
  <message>
   <source>No camera found: {why}. To begin, {advice} (Enter takes the first). Another sport? Click here</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Keine Kamera gefunden: {why}. Zu Beginn {advice} (Eingabe nimmt das erste). Andere Sportart? Hier klicken</translation>
  </message>
  <message>
   <source>Camera found, sure: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Kamera gefunden, sicher: {why}</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}: its lines are looked for …</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Kamera gezogen, {pegs}: ihre Linien werden gesucht …</translation>
  </message>
  <message>
   <source>Camera of the track, unsure: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>Kamera der Spur, unsicher: {why}</translation>
  </message>
  <message>
   <source>nothing changed: regular already, or no painted line was found there</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>nichts geändert: schon regelmäßig, oder dort fand sich keine gemalte Linie</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, along the track; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{what} von {frame} kopiert, entlang der Spur; Umschalt+V bestätigt alle</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, moved with the camera; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{what} von {frame} kopiert, mit der Kamera verschoben; Umschalt+V bestätigt alle</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, as they were: no motion found; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{what} von {frame} kopiert, wie sie waren: keine Bewegung gefunden; Umschalt+V bestätigt alle</translation>
  </message>
  <message>
   <source>taken back: nothing is regularised</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>zurückgenommen: nichts wird begradigt</translation>
  </message>
  <message>
   <source>taken back: nothing is copied</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>zurückgenommen: nichts wird kopiert</translation>
  </message>
  <message>
   <source>the frame was left: nothing was regularised</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>das Bild wurde verlassen: nichts wurde begradigt</translation>
  </message>
  <message>
   <source>the frame was left: nothing was copied</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>das Bild wurde verlassen: nichts wurde kopiert</translation>
  </message>
  <message numerus="yes">
   <source>{n} points unconfirmed by paint</source>
   <extracomment>{n} point unconfirmed by paint / {n} points unconfirmed by paint [procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>
    <numerusform>{n} Punkt nicht durch Farbe bestätigt</numerusform>
    <numerusform>{n} Punkte nicht durch Farbe bestätigt</numerusform>
   </translation>
  </message>
  <message>
   <source>regularise {what}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{what} begradigen</translation>
  </message>
  <message>
   <source>copy from {frame}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>von {frame} kopieren</translation>
  </message>
  <message>
   <source>left out, not in the picture or no line seen: {elements}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>ausgelassen, nicht im Bild oder keine Linie zu sehen: {elements}</translation>
  </message>
  <message>
   <source>choose an annotated element first</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py, procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>wählen Sie zuerst ein annotiertes Element</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements</source>
   <extracomment>{n} element / {n} elements [procc_annotator/gui/commands/assistant.py, procc_annotator/gui/commands/label_check.py, procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>
    <numerusform>{n} Element</numerusform>
    <numerusform>{n} Elemente</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>regularised {what}: {n} points</source>
   <extracomment>regularised {what}: {n} point / regularised {what}: {n} points [procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>
    <numerusform>{what} begradigt: {n} Punkt</numerusform>
    <numerusform>{what} begradigt: {n} Punkte</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} has corners or is one place: it stays as it is</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{element} hat Ecken oder ist ein einzelner Ort: es bleibt, wie es ist</translation>
  </message>
  <message>
   <source>no element of the field is annotated here</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>hier ist kein Element des Feldes annotiert</translation>
  </message>
  <message>
   <source>no frame before this one is annotated</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>kein Bild vor diesem ist annotiert</translation>
  </message>
  <message>
   <source>{frame} has no element that is missing here</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{frame} hat kein Element, das hier fehlt</translation>
  </message>
  <message>
   <source>{element} becomes {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} wird {other}</translation>
  </message>
  <message>
   <source>duplicate {element} as {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} als {other} kopieren</translation>
  </message>
  <message>
   <source>merge {element} into {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} mit {other} vereinen</translation>
  </message>
  <message>
   <source>close gaps</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>Lücken schließen</translation>
  </message>
  <message numerus="yes">
   <source>confirm {n} elements</source>
   <extracomment>confirm {n} element / confirm {n} elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>{n} Element bestätigen</numerusform>
    <numerusform>{n} Elemente bestätigen</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>drop {n} unconfirmed elements</source>
   <extracomment>drop {n} unconfirmed element / drop {n} unconfirmed elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>{n} unbestätigtes Element verwerfen</numerusform>
    <numerusform>{n} unbestätigte Elemente verwerfen</numerusform>
   </translation>
  </message>
  <message>
   <source>Name of the line</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>Name der Linie</translation>
  </message>
  <message>
   <source>What is this line?</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>Welche Linie ist das?</translation>
  </message>
  <message>
   <source>{element} is a curve, which two points do not show: click on</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} ist eine Kurve, die zwei Punkte nicht zeigen: weiterklicken</translation>
  </message>
  <message>
   <source>swap {element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} und {other} tauschen</translation>
  </message>
  <message>
   <source>{element} is its own symmetric element</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} ist seine eigene symmetrische Klasse</translation>
  </message>
  <message numerus="yes">
   <source>{elements} are annotated already</source>
   <extracomment>{elements} is annotated already / {elements} are annotated already [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>{elements} ist schon annotiert</numerusform>
    <numerusform>{elements} sind schon annotiert</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} lies where {other} is: drag it to its place</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} liegt, wo {other} ist: ziehen Sie es an seinen Platz</translation>
  </message>
  <message>
   <source>reverse {element}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} umkehren</translation>
  </message>
  <message>
   <source>choose the point to split at first (edit mode)</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>wählen Sie zuerst den Punkt, an dem geteilt werden soll (beim Bearbeiten)</translation>
  </message>
  <message>
   <source>split {element}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} teilen</translation>
  </message>
  <message numerus="yes">
   <source>confirmed {n} elements</source>
   <extracomment>confirmed {n} element / confirmed {n} elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>{n} Element bestätigt</numerusform>
    <numerusform>{n} Elemente bestätigt</numerusform>
   </translation>
  </message>
  <message>
   <source>nothing is unconfirmed on this frame</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>in diesem Bild ist nichts unbestätigt</translation>
  </message>
  <message>
   <source>{element} is annotated already</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} ist bereits annotiert</translation>
  </message>
  <message>
   <source>no end is that near to a corner or the picture's edge</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>kein Ende liegt so nahe an einer Ecke oder am Bildrand</translation>
  </message>
  <message numerus="yes">
   <source>dropped {n} unconfirmed elements</source>
   <extracomment>dropped {n} unconfirmed element / dropped {n} unconfirmed elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>{n} unbestätigtes Element verworfen</numerusform>
    <numerusform>{n} unbestätigte Elemente verworfen</numerusform>
   </translation>
  </message>
  <message>
   <source>Another element…</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>Anderes Element…</translation>
  </message>
  <message>
   <source>Leave it unnamed</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>Unbenannt lassen</translation>
  </message>
  <message>
   <source>an element is split at a point between its ends, into a class that is free</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>ein Element wird an einem Punkt zwischen seinen Enden geteilt, in eine freie Klasse</translation>
  </message>
  <message>
   <source>{element} was changed elsewhere: look at it again</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} wurde anderswo geändert: sehen Sie noch einmal hin</translation>
  </message>
  <message>
   <source>? (stays as it is, an unknown class)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>? (bleibt, wie es ist, eine unbekannte Klasse)</translation>
  </message>
  <message>
   <source>Leave out</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, the action off_plane_left_out, the setting off_plane]</extracomment>
   <translation>Auslassen</translation>
  </message>
  <message>
   <source>Label</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Label</translation>
  </message>
  <message>
   <source>Shapes</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Formen</translation>
  </message>
  <message>
   <source>Stands for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Steht für</translation>
  </message>
  <message>
   <source>Why</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Warum</translation>
  </message>
  <message>
   <source>sure</source>
   <comment>a proposal</comment>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>sicher</translation>
  </message>
  <message>
   <source>likely</source>
   <comment>a proposal</comment>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>wahrscheinlich</translation>
  </message>
  <message>
   <source>to be said</source>
   <comment>a proposal</comment>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>zu sagen</translation>
  </message>
  <message numerus="yes">
   <source>{n} labels are no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on.</source>
   <extracomment>{n} label is no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on. / {n} labels are no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on. [procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>
    <numerusform>{n} Label ist keine Klasse von {field}. Sagen Sie, wofür es steht; der Vorschlag folgt aus seinen Wörtern und daraus, auf welchen Elementen seine Formen liegen.</numerusform>
    <numerusform>{n} Labels sind keine Klassen von {field}. Sagen Sie, wofür sie stehen; die Vorschläge folgen aus ihren Wörtern und daraus, auf welchen Elementen ihre Formen liegen.</numerusform>
   </translation>
  </message>
  <message>
   <source>These names are more like those of {field}: choose that field first (File &gt; Field).</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Diese Namen gleichen eher denen von {field}: wählen Sie zuerst dieses Feld (Datei &gt; Feld).</translation>
  </message>
  <message>
   <source>Names of another program</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Namen eines anderen Programms</translation>
  </message>
  <message>
   <source>Keep these names with the dataset ({file})</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Diese Namen beim Datensatz behalten ({file})</translation>
  </message>
  <message>
   <source>Import</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Importieren</translation>
  </message>
  <message>
   <source>What {label} stands for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Wofür {label} steht</translation>
  </message>
  <message>
   <source>What came of it</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Was daraus wurde</translation>
  </message>
  <message>
   <source>Import annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Annotationen importieren</translation>
  </message>
  <message>
   <source>Annotations to import</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Zu importierende Annotationen</translation>
  </message>
  <message>
   <source>Look into the files</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>In die Dateien sehen</translation>
  </message>
  <message>
   <source>Only frames without annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Nur Bilder, in denen noch nichts annotiert ist</translation>
  </message>
  <message>
   <source>Replace what is annotated in the others, too</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Auch in den anderen ersetzen, was annotiert ist</translation>
  </message>
  <message>
   <source>What was there stays among the earlier versions of its frame, and undo brings it back</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Was da war, bleibt unter den früheren Fassungen des Bildes, und Rückgängig holt es zurück</translation>
  </message>
  <message>
   <source>Annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Annotationen</translation>
  </message>
  <message>
   <source>Format</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Format</translation>
  </message>
  <message>
   <source>Import into</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Importieren in</translation>
  </message>
  <message>
   <source>Annotations (*.json *.xml *.zip);;All files (*)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Annotationen (*.json *.xml *.zip);;Alle Dateien (*)</translation>
  </message>
  <message>
   <source>Export as</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Exportieren als</translation>
  </message>
  <message>
   <source>Export…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, procc_annotator/gui/panels/findings.py, procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Exportieren…</translation>
  </message>
  <message>
   <source>One zip archive instead of a folder</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Ein Zip-Archiv statt eines Ordners</translation>
  </message>
  <message>
   <source>Replace files that are there</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Vorhandene Dateien ersetzen</translation>
  </message>
  <message>
   <source>Keep elements that SoccerNet has no class for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Elemente behalten, für die SoccerNet keine Klasse hat</translation>
  </message>
  <message>
   <source>Width of the lines</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Breite der Linien</translation>
  </message>
  <message>
   <source>Copy the pictures as well</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Auch die Bilder kopieren</translation>
  </message>
  <message>
   <source>Export to a folder</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>In einen Ordner exportieren</translation>
  </message>
  <message>
   <source>Keeps {holds}.
Loses {loses}.</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Behält {holds}.
Verliert {loses}.</translation>
  </message>
  <message>
   <source>Add these names to the dataset's {file}, written anew</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Diese Namen in {file} des Datensatzes aufnehmen, neu geschrieben</translation>
  </message>
  <message>
   <source>Cancel</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, procc_annotator/gui/commands/opening.py, procc_annotator/gui/messages.py]</extracomment>
   <translation>Abbrechen</translation>
  </message>
  <message>
   <source>Close</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Schließen</translation>
  </message>
  <message>
   <source>A folder, a zip archive, or one file</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Ein Ordner, ein Zip-Archiv oder eine Datei</translation>
  </message>
  <message>
   <source>File…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Datei…</translation>
  </message>
  <message>
   <source>Folder…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Ordner…</translation>
  </message>
  <message>
   <source>Frames are matched by the name of their picture.</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Bilder werden nach dem Namen der Bilddatei zugeordnet.</translation>
  </message>
  <message>
   <source>Zip archive (*.zip)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>Zip-Archiv (*.zip)</translation>
  </message>
  <message>
   <source>{frames}, {elements} and {points} written to {path} ({format}).</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{frames}, {elements} und {points} nach {path} geschrieben ({format}).</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} annotations</source>
   <extracomment>{n:,} annotation / {n:,} annotations [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} Annotation</numerusform>
    <numerusform>{n:,} Annotationen</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>JaC of {n:,} frames</source>
   <extracomment>JaC of {n:,} frame / JaC of {n:,} frames [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>JaC von {n:,} Bild</numerusform>
    <numerusform>JaC von {n:,} Bildern</numerusform>
   </translation>
  </message>
  <message>
   <source>Not everything could be saved: what is on disk goes.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Nicht alles ließ sich speichern: es gilt, was auf der Platte ist.</translation>
  </message>
  <message>
   <source>Nothing was written: no frame is annotated, or none could be written.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Nichts geschrieben: kein Bild ist annotiert, oder keines ließ sich schreiben.</translation>
  </message>
  <message>
   <source>the fit of {frame} is saved as {path}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>die Anpassung von {frame} ist als {path} gespeichert</translation>
  </message>
  <message>
   <source>{source} is made from the clicks it would be scored against: judge the cameras to be scored (procc-annotator calibrate fits and scores a set)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{source} entsteht aus den Klicks, an denen es gemessen würde: beurteilen Sie die zu bewertenden Kameras (procc-annotator calibrate passt einen Satz an und bewertet ihn)</translation>
  </message>
  <message>
   <source>{annotations} and {scores}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{annotations} und {scores}</translation>
  </message>
  <message>
   <source>nothing: no frame is annotated</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>nichts: kein Bild ist annotiert</translation>
  </message>
  <message>
   <source>export: cancelled; files that were written already are still there</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Export: abgebrochen; schon geschriebene Dateien sind noch da</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames</source>
   <extracomment>{n:,} frame / {n:,} frames [procc_annotator/gui/commands/exporting.py, procc_annotator/gui/commands/opening.py, procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild</numerusform>
    <numerusform>{n:,} Bilder</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} elements</source>
   <extracomment>{n:,} element / {n:,} elements [procc_annotator/gui/commands/exporting.py, procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>
    <numerusform>{n:,} Element</numerusform>
    <numerusform>{n:,} Elemente</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} points</source>
   <extracomment>{n:,} point / {n:,} points [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} Punkt</numerusform>
    <numerusform>{n:,} Punkte</numerusform>
   </translation>
  </message>
  <message>
   <source>Zip archive (*.zip);;Folder (*)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Zip-Archiv (*.zip);;Ordner (*)</translation>
  </message>
  <message>
   <source>Save copies to</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Kopien sichern in</translation>
  </message>
  <message numerus="yes">
   <source>copied {n:,} frames to {folder}; they are not saved in their own place yet</source>
   <extracomment>copied {n:,} frame to {folder}; it is not saved in its own place yet / copied {n:,} frames to {folder}; they are not saved in their own place yet [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild nach {folder} kopiert; am eigenen Ort ist es noch nicht gespeichert</numerusform>
    <numerusform>{n:,} Bilder nach {folder} kopiert; am eigenen Ort sind sie noch nicht gespeichert</numerusform>
   </translation>
  </message>
  <message>
   <source>Table (*.csv);;JSON (*.json)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Tabelle (*.csv);;JSON (*.json)</translation>
  </message>
  <message>
   <source>Table (*.csv)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py, procc_annotator/gui/commands/label_check.py, procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Tabelle (*.csv)</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} frames to {path}</source>
   <extracomment>exported {n:,} frame to {path} / exported {n:,} frames to {path} [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild nach {path} exportiert</numerusform>
    <numerusform>{n:,} Bilder nach {path} exportiert</numerusform>
   </translation>
  </message>
  <message>
   <source>the set was being scored still: some frames have no JaC yet</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>der Satz wurde noch bewertet: einige Bilder haben noch keinen JaC</translation>
  </message>
  <message>
   <source>no camera to save: the fit is not there yet</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>keine Kamera zu speichern: die Anpassung ist noch nicht da</translation>
  </message>
  <message>
   <source>blind: no frame is committed yet, so there is no JaC to show</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>blind: noch ist kein Bild abgegeben, also gibt es keinen JaC zu zeigen</translation>
  </message>
  <message>
   <source>exported {what} to {path}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{what} nach {path} exportiert</translation>
  </message>
  <message>
   <source>Cancelled; files that were written already are still there.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Abgebrochen; schon geschriebene Dateien sind noch da.</translation>
  </message>
  <message>
   <source>Not written</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Nicht geschrieben</translation>
  </message>
  <message>
   <source>What the format cannot hold</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Was das Format nicht fassen kann</translation>
  </message>
  <message>
   <source>everything is saved in its own place</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>alles ist am eigenen Ort gespeichert</translation>
  </message>
  <message>
   <source>no camera to save: {why}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>keine Kamera zu speichern: {why}</translation>
  </message>
  <message>
   <source>the fit is worked out again: save it in a moment</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>die Anpassung wird neu berechnet: speichern Sie sie gleich</translation>
  </message>
  <message>
   <source>{frame}: the picture cannot be read, so that the camera's pixels belong to no size; not saved</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{frame}: das Bild ist unlesbar, so dass die Pixel der Kamera zu keiner Größe gehören; nicht gespeichert</translation>
  </message>
  <message>
   <source>saved as {path}, but the loaded cameras could not be read again: {problem}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>als {path} gespeichert, aber die geladenen Kameras ließen sich nicht neu lesen: {problem}</translation>
  </message>
  <message>
   <source>{saved}; it is hardly determined: {why}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{saved}; kaum bestimmt: {why}</translation>
  </message>
  <message>
   <source>not everything could be saved: the export has the last saved state</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>nicht alles ließ sich speichern: der Export hat den zuletzt gespeicherten Stand</translation>
  </message>
  <message numerus="yes">
   <source>blind mode leaves out {n:,} frames not committed yet</source>
   <extracomment>blind mode leaves out {n:,} frame not committed yet / blind mode leaves out {n:,} frames not committed yet [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>der Blindmodus lässt {n:,} noch nicht abgegebenes Bild aus</numerusform>
    <numerusform>der Blindmodus lässt {n:,} noch nicht abgegebene Bilder aus</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} files could not be read: {problem}</source>
   <extracomment>{n:,} file could not be read: {problem} / {n:,} files could not be read: {problem} [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} Datei war unlesbar: {problem}</numerusform>
    <numerusform>{n:,} Dateien waren unlesbar: {problem}</numerusform>
   </translation>
  </message>
  <message>
   <source>Export</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>Exportieren</translation>
  </message>
  <message>
   <source>exporting {done} / {total}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>exportiert {done} / {total}</translation>
  </message>
  <message>
   <source>Keep the field, and say nothing more of these classes</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Das Feld behalten und zu diesen Klassen nichts mehr sagen</translation>
  </message>
  <message>
   <source>The dataset remembers it, and is not asked about again</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Der Datensatz merkt es sich und wird nicht noch einmal gefragt</translation>
  </message>
  <message>
   <source>No, {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Nein, {field}</translation>
  </message>
  <message>
   <source>The field of this dataset</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Das Feld dieses Datensatzes</translation>
  </message>
  <message>
   <source>Descriptions of fields (*.toml)</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Feldbeschreibungen (*.toml)</translation>
  </message>
  <message>
   <source>Is this {field}? The classes annotated here are those of {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Ist das {field}? Die hier annotierten Klassen sind die von {field}</translation>
  </message>
  <message>
   <source>{why}, but {file} in the dataset's folder decides</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>{why}, aber {file} im Ordner des Datensatzes entscheidet</translation>
  </message>
  <message>
   <source>Yes, {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Ja, {field}</translation>
  </message>
  <message>
   <source>Switch to {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>Zu {field} wechseln</translation>
  </message>
  <message>
   <source>{problem}; the field stays as it was: {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>{problem}; das Feld blieb, wie es war: {field}</translation>
  </message>
  <message>
   <source>Scores then differ from those of the nominal field ({nominal}), as official evaluations take it; they name the dimensions they were computed with.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Bewertungen weichen dann von denen des Nennfeldes ({nominal}) ab, das offizielle Auswertungen nehmen; sie nennen die Maße, mit denen sie berechnet sind.</translation>
  </message>
  <message>
   <source>Dimensions of their own (stadiums.csv): {frames} of {stadiums}. What is entered here is for all others, and for what stadiums leave open.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Eigene Maße (stadiums.csv): {frames} von {stadiums}. Was hier eingegeben wird, gilt für alle anderen, und für das, was Stadien offenlassen.</translation>
  </message>
  <message>
   <source>Scores then differ from those of official evaluations, which take lines where the rules measure them; they say so.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Bewertungen weichen dann von denen offizieller Auswertungen ab, die Linien dort nehmen, wo die Regeln sie messen; sie sagen es.</translation>
  </message>
  <message>
   <source>Rules measure many lines at an edge of their paint. Clicks are put on its middle, half the paint's width away: choose it where that matters, as in halls and near the camera.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Die Regeln messen viele Linien an einer Kante ihrer Farbe. Klicks liegen auf deren Mitte, die halbe Linienbreite daneben: wählen Sie das, wo es darauf ankommt, etwa in Hallen und nahe der Kamera.</translation>
  </message>
  <message>
   <source>Only length and width are found from frames, and the rules fix those of this field</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Nur Länge und Breite werden aus Bildern bestimmt, und die Regeln legen die dieses Feldes fest</translation>
  </message>
  <message numerus="yes">
   <source>{dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frames.</source>
   <extracomment>{dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frame. / {dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frames. [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{dimension}: {value:.2f} ± {sd:.2f} m, aus {n} Bild.</numerusform>
    <numerusform>{dimension}: {value:.2f} ± {sd:.2f} m, aus {n} Bildern.</numerusform>
   </translation>
  </message>
  <message>
   <source>where the rules measure</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>wo die Regeln messen</translation>
  </message>
  <message>
   <source>the middle of the paint</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>in der Mitte der Farbe</translation>
  </message>
  <message>
   <source>Field dimensions: {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Feldmaße: {field}</translation>
  </message>
  <message numerus="yes">
   <source>From the cameras of {n} frames; ± is one standard deviation.</source>
   <extracomment>From the cameras of {n} frame; ± is one standard deviation. / From the cameras of {n} frames; ± is one standard deviation. [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>Aus der Kamera von {n} Bild; ± ist eine Standardabweichung.</numerusform>
    <numerusform>Aus den Kameras von {n} Bildern; ± ist eine Standardabweichung.</numerusform>
   </translation>
  </message>
  <message>
   <source>{remark}; it stays as it was.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>{remark}; es blieb, wie es war.</translation>
  </message>
  <message>
   <source>Estimate from this set</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Aus diesem Satz schätzen</translation>
  </message>
  <message>
   <source>Clicks lie on:</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Klicks liegen:</translation>
  </message>
  <message>
   <source>Keep for this dataset</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Für diesen Datensatz behalten</translation>
  </message>
  <message>
   <source>Nominal</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Nennmaße</translation>
  </message>
  <message>
   <source>The field as official evaluations take it</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Das Feld, wie offizielle Auswertungen es nehmen</translation>
  </message>
  <message>
   <source>nominal {nominal:g} m, the rules allow {minimum:g} to {maximum:g} m</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Nennmaß {nominal:g} m, die Regeln erlauben {minimum:g} bis {maximum:g} m</translation>
  </message>
  <message>
   <source>&lt;b&gt;not {number:g} m: the rules allow {minimum:g} to {maximum:g} m&lt;/b&gt;</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>&lt;b&gt;nicht {number:g} m: die Regeln erlauben {minimum:g} bis {maximum:g} m&lt;/b&gt;</translation>
  </message>
  <message numerus="yes">
   <source>{n} frames</source>
   <extracomment>{n} frame / {n} frames [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{n} Bild</numerusform>
    <numerusform>{n} Bilder</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n} stadiums</source>
   <extracomment>{n} stadium / {n} stadiums [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{n} Stadion</numerusform>
    <numerusform>{n} Stadien</numerusform>
   </translation>
  </message>
  <message>
   <source>Blind: frames that are not committed took no part ({n}).</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Blind: nicht abgegebene Bilder nahmen nicht teil ({n}).</translation>
  </message>
  <message>
   <source>Frames that cannot be read took no part: {n}.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Unlesbare Bilder nahmen nicht teil: {n}.</translation>
  </message>
  <message>
   <source>Stop</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py, procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Anhalten</translation>
  </message>
  <message>
   <source>the rules fix every dimension of the field {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>die Regeln legen jedes Maß des Feldes {field} fest</translation>
  </message>
  <message>
   <source>Blind: the set is checked once one of its frames is committed (Ctrl+Enter).</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>Blind: der Satz wird angesehen, sobald ein Bild davon abgegeben ist (Strg+Eingabe).</translation>
  </message>
  <message>
   <source>no further frame this way: {what}</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>kein weiteres Bild in dieser Richtung: {what}</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: JaC {value:.3f}</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{place} von {total}, schlechteste zuerst: JaC {value:.3f}</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: largest error {value:.1f} px</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{place} von {total}, schlechteste zuerst: größter Fehler {value:.1f} px</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: median disagreement {value:.2f} m</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{place} von {total}, schlechteste zuerst: mediane Abweichung {value:.2f} m</translation>
  </message>
  <message>
   <source>{place} of {total}, the least sure first</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{place} von {total}, unsicherste zuerst</translation>
  </message>
  <message>
   <source>none is annotated</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>keines ist annotiert</translation>
  </message>
  <message>
   <source>all are annotated</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>alle sind annotiert</translation>
  </message>
  <message>
   <source>all are done or approved</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>alle sind fertig oder freigegeben</translation>
  </message>
  <message>
   <source>none is rejected</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>keines ist abgelehnt</translation>
  </message>
  <message>
   <source>this is the last one</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>dies ist das letzte</translation>
  </message>
  <message>
   <source>no frame with a score to go to</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>kein bewertetes Bild, zu dem zu gehen wäre</translation>
  </message>
  <message>
   <source>no frame with a score to go to: blind mode shows those of committed frames only</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>kein bewertetes Bild, zu dem zu gehen wäre: der Blindmodus zeigt nur abgegebene Bilder</translation>
  </message>
  <message>
   <source>comparing {source} with {other} over the set</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{source} wird über den Satz mit {other} verglichen</translation>
  </message>
  <message>
   <source>blind mode: how the track does is hidden</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>Blindmodus: wie gut die Spur ist, bleibt verborgen</translation>
  </message>
  <message>
   <source>no shot was followed yet (T)</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>noch wurde keiner Einstellung gefolgt (T)</translation>
  </message>
  <message>
   <source>no other frame is unsure</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>kein anderes Bild ist unsicher</translation>
  </message>
  <message>
   <source>these frames do not follow one another</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>diese Bilder folgen nicht aufeinander</translation>
  </message>
  <message>
   <source>two sources are needed to see where they disagree: load more cameras (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>zwei Quellen sind nötig, um zu sehen, wo sie abweichen: laden Sie mehr Kameras (Strg+L)</translation>
  </message>
  <message>
   <source>{source} and {other} cannot be compared on the ground in any frame</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{source} und {other} lassen sich in keinem Bild am Boden vergleichen</translation>
  </message>
  <message>
   <source>stopped comparing the sources</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>Vergleich der Quellen angehalten</translation>
  </message>
  <message>
   <source>this is the worst; once more goes on</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>das ist das schlechteste; noch einmal geht weiter</translation>
  </message>
  <message>
   <source>no other frame has a score</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>kein anderes Bild ist bewertet</translation>
  </message>
  <message>
   <source>from the worst again</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>wieder vom schlechtesten an</translation>
  </message>
  <message>
   <source>two sources are being compared already</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>zwei Quellen werden schon verglichen</translation>
  </message>
  <message>
   <source>{source} and {other} are compared</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{source} und {other} sind verglichen</translation>
  </message>
  <message>
   <source>none is doubtful</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>keines ist zweifelhaft</translation>
  </message>
  <message>
   <source>skipped (under {least:.0%} visible): {ghosts}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>übergangen (weniger als {least:.0%} sichtbar): {ghosts}</translation>
  </message>
  <message numerus="yes">
   <source>{n} points</source>
   <extracomment>{n} point / {n} points [procc_annotator/gui/commands/ghost_accepting.py, procc_annotator/gui/commands/versions.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>
    <numerusform>{n} Punkt</numerusform>
    <numerusform>{n} Punkte</numerusform>
   </translation>
  </message>
  <message>
   <source>{accepted}: {points}, line seen along {share:.0%}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{accepted}: {points}, Linie zu {share:.0%} zu sehen</translation>
  </message>
  <message numerus="yes">
   <source>{n} ends of {elements} cannot be seen: the points stop before</source>
   <extracomment>{n} end of {elements} cannot be seen: the points stop before / {n} ends of {elements} cannot be seen: the points stop before [procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>
    <numerusform>{n} Ende von {elements} ist nicht zu sehen: die Punkte hören davor auf</numerusform>
    <numerusform>{n} Enden von {elements} sind nicht zu sehen: die Punkte hören davor auf</numerusform>
   </translation>
  </message>
  <message>
   <source>the camera is another one meanwhile</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>die Kamera ist inzwischen eine andere</translation>
  </message>
  <message>
   <source>accept {what}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{what} annehmen</translation>
  </message>
  <message numerus="yes">
   <source>{n} ghosts</source>
   <extracomment>{n} ghost / {n} ghosts [procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>
    <numerusform>{n} Geist</numerusform>
    <numerusform>{n} Geister</numerusform>
   </translation>
  </message>
  <message>
   <source>{n} of {total} ghosts</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{n} von {total} Geistern</translation>
  </message>
  <message>
   <source>accepted {what}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{what} angenommen</translation>
  </message>
  <message>
   <source>the frame was edited meanwhile</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>das Bild wurde inzwischen bearbeitet</translation>
  </message>
  <message>
   <source>looking for the line on {frame} took too long</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>die Suche nach der Linie auf {frame} dauerte zu lange</translation>
  </message>
  <message>
   <source>{element} is not accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element} ist nicht angenommen: {why}</translation>
  </message>
  <message>
   <source>{element}: no painted line is found along it; click it by hand, or say that it is not visible here (.)</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element}: keine gemalte Linie gefunden; klicken Sie es von Hand, oder sagen Sie, dass es hier nicht sichtbar ist (.)</translation>
  </message>
  <message>
   <source>the camera is being fitted: accept its ghosts in a moment</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>die Kamera wird angepasst: nehmen Sie ihre Geister gleich an</translation>
  </message>
  <message>
   <source>no ghost accepted, under {least:.0%} of the line visible: {ghosts}; Tab goes through them</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>kein Geist angenommen, weniger als {least:.0%} der Linie sichtbar: {ghosts}; Tab geht sie durch</translation>
  </message>
  <message>
   <source>accepted {what} on {frame}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{what} auf {frame} angenommen</translation>
  </message>
  <message>
   <source>no ghost was accepted: there is no picture to look for their lines in</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>kein Geist angenommen: es gibt kein Bild, um ihre Linien zu suchen</translation>
  </message>
  <message>
   <source>no ghost was accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>kein Geist angenommen: {why}</translation>
  </message>
  <message>
   <source>{element} is not accepted</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element} ist nicht angenommen</translation>
  </message>
  <message>
   <source>the ghost is accepted: accept the ghosts of the new fit</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>der Geist ist angenommen: nehmen Sie die Geister der neuen Anpassung an</translation>
  </message>
  <message>
   <source>what was being drawn is finished: accept the ghosts of the new fit</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>das Gezeichnete ist beendet: nehmen Sie die Geister der neuen Anpassung an</translation>
  </message>
  <message>
   <source>no ghost was accepted</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>kein Geist angenommen</translation>
  </message>
  <message>
   <source>{element} is accepted once its points are found</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element} ist angenommen, sobald seine Punkte gefunden sind</translation>
  </message>
  <message>
   <source>go to a ghost (Tab) or choose an element first</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>gehen Sie zuerst zu einem Geist (Tab) oder wählen Sie ein Element</translation>
  </message>
  <message numerus="yes">
   <source>{n} ghosts left, Tab begins again</source>
   <extracomment>{n} ghost left, Tab begins again / {n} ghosts left, Tab begins again [procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>
    <numerusform>{n} Geist bleibt, Tab beginnt von vorn</numerusform>
    <numerusform>{n} Geister bleiben, Tab beginnt von vorn</numerusform>
   </translation>
  </message>
  <message>
   <source>that was the last ghost</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>das war der letzte Geist</translation>
  </message>
  <message>
   <source>that was the first ghost</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>das war der erste Geist</translation>
  </message>
  <message>
   <source>the camera is being fitted: ghosts come in a moment</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>die Kamera wird angepasst: Geister kommen gleich</translation>
  </message>
  <message>
   <source>no ghosts: the camera is looked for in the picture</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>keine Geister: die Kamera wird im Bild gesucht</translation>
  </message>
  <message>
   <source>no ghosts: no camera is known; {advice}</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>keine Geister: keine Kamera bekannt; {advice}</translation>
  </message>
  <message>
   <source>no ghosts: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>keine Geister: {why}</translation>
  </message>
  <message>
   <source>no ghosts: what else is in sight is annotated, or not known well enough</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>keine Geister: was sonst zu sehen ist, ist annotiert oder nicht gut genug bekannt</translation>
  </message>
  <message>
   <source>no ghosts: they are switched off (Element &gt; Ghosts &gt; Show ghosts)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>keine Geister: sie sind ausgeschaltet (Element &gt; Geister &gt; Geister zeigen)</translation>
  </message>
  <message>
   <source>overlays are hidden: no ghost can be seen (Ctrl+H, or let go of X)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>Überlagerungen sind ausgeblendet: kein Geist ist zu sehen (Strg+H, oder X loslassen)</translation>
  </message>
  <message>
   <source>finish what is being drawn first (Enter), or cancel it (Esc)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>beenden Sie zuerst, was gezeichnet wird (Eingabe), oder brechen Sie es ab (Esc)</translation>
  </message>
  <message>
   <source>no ghosts: no camera could be fitted</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>keine Geister: keine Kamera ließ sich anpassen</translation>
  </message>
  <message>
   <source>no camera fits yet</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>noch passt keine Kamera</translation>
  </message>
  <message>
   <source>it is being drawn by hand</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>es wird von Hand gezeichnet</translation>
  </message>
  <message>
   <source>{title} is annotated here: delete it first (Ctrl+Delete)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} ist hier annotiert: löschen Sie es zuerst (Strg+Entf)</translation>
  </message>
  <message>
   <source>{title} is not visible here; Ctrl+. takes it back</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} ist hier nicht sichtbar; Strg+. nimmt es zurück</translation>
  </message>
  <message>
   <source>{title} may be visible here again</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} ist hier vielleicht wieder sichtbar</translation>
  </message>
  <message>
   <source>no element of this frame was said to be not visible</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>kein Element dieses Bildes galt als nicht sichtbar</translation>
  </message>
  <message>
   <source>go to a ghost first (Tab)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>gehen Sie zuerst zu einem Geist (Tab)</translation>
  </message>
  <message>
   <source>{off}; choose an element first</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{off}; wählen Sie zuerst ein Element</translation>
  </message>
  <message numerus="yes">
   <source>{edited} of {n:,} frames imported ({format}).</source>
   <extracomment>{edited} of {n:,} frame imported ({format}). / {edited} of {n:,} frames imported ({format}). [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{edited} von {n:,} Bild importiert ({format}).</numerusform>
    <numerusform>{edited} von {n:,} Bildern importiert ({format}).</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>Cancelled: {n:,} frames were not checked.</source>
   <extracomment>Cancelled: {n:,} frame was not checked. / Cancelled: {n:,} frames were not checked. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>Abgebrochen: {n:,} Bild wurde nicht angesehen.</numerusform>
    <numerusform>Abgebrochen: {n:,} Bilder wurden nicht angesehen.</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames are annotated already and left unchanged.</source>
   <extracomment>{n:,} frame is annotated already and left unchanged. / {n:,} frames are annotated already and left unchanged. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild ist schon annotiert und blieb unverändert.</numerusform>
    <numerusform>{n:,} Bilder sind schon annotiert und blieben unverändert.</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames hold the same already.</source>
   <extracomment>{n:,} frame holds the same already. / {n:,} frames hold the same already. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild enthält bereits dasselbe.</numerusform>
    <numerusform>{n:,} Bilder enthalten bereits dasselbe.</numerusform>
   </translation>
  </message>
  <message>
   <source>import</source>
   <comment>a step</comment>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Importieren</translation>
  </message>
  <message numerus="yes">
   <source>{edited} of {n:,} frames imported</source>
   <extracomment>{edited} of {n:,} frame imported / {edited} of {n:,} frames imported [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{edited} von {n:,} Bild importiert</numerusform>
    <numerusform>{edited} von {n:,} Bildern importiert</numerusform>
   </translation>
  </message>
  <message>
   <source>Cancelled; nothing was imported.</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Abgebrochen; nichts wurde importiert.</translation>
  </message>
  <message>
   <source>Left as they were</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Gelassen, wie sie waren</translation>
  </message>
  <message>
   <source>Could not be read</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Nicht lesbar</translation>
  </message>
  <message>
   <source>Without a picture here ({n})</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Ohne Bild hier ({n})</translation>
  </message>
  <message>
   <source>Changed or left out</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>Geändert oder ausgelassen</translation>
  </message>
  <message>
   <source>it could not be saved: {why}</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>es ließ sich nicht speichern: {why}</translation>
  </message>
  <message>
   <source>error</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>Fehler</translation>
  </message>
  <message>
   <source>warning</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>Warnung</translation>
  </message>
  <message>
   <source>hint</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>Hinweis</translation>
  </message>
  <message>
   <source>finding {place} of {total}, {severity}: {elements}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>Befund {place} von {total}, {severity}: {elements}</translation>
  </message>
  <message>
   <source>no finding is as sure as the Check panel is set to show</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>kein Befund ist so sicher, wie der Bereich Befunde eingestellt ist</translation>
  </message>
  <message numerus="yes">
   <source>relabelled {n} elements</source>
   <extracomment>relabelled {n} element / relabelled {n} elements [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n} Element umbenannt</numerusform>
    <numerusform>{n} Elemente umbenannt</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>checked {n:,} frames, camera model {model}: {found}</source>
   <extracomment>checked {n:,} frame, camera model {model}: {found} / checked {n:,} frames, camera model {model}: {found} [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild geprüft, Kameramodell {model}: {found}</numerusform>
    <numerusform>{n:,} Bilder geprüft, Kameramodell {model}: {found}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} checked frames</source>
   <extracomment>{n:,} checked frame / {n:,} checked frames [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} geprüftes Bild</numerusform>
    <numerusform>{n:,} geprüfte Bilder</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} und {other}</translation>
  </message>
  <message>
   <source>the label check is still looking at this frame</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>die Klassenprüfung sieht sich dieses Bild noch an</translation>
  </message>
  <message>
   <source>the label check has found nothing; check the whole set to look at all frames</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>die Klassenprüfung hat nichts gefunden; prüfen Sie den ganzen Satz, um alle Bilder anzusehen</translation>
  </message>
  <message>
   <source>{done}; Ctrl+Z takes it back</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{done}; Strg+Z nimmt es zurück</translation>
  </message>
  <message>
   <source>removed point {n} of {element}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>Punkt {n} von {element} entfernt</translation>
  </message>
  <message>
   <source>swapped {element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} und {other} getauscht</translation>
  </message>
  <message>
   <source>relabelled {element} to {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} in {other} umbenannt</translation>
  </message>
  <message>
   <source>ignored until {elements} changes; the Check panel brings it back</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>übergangen, bis sich {elements} ändert; der Bereich Befunde holt es zurück</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames cannot be checked</source>
   <extracomment>{n:,} frame cannot be checked / {n:,} frames cannot be checked [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild lässt sich nicht prüfen</numerusform>
    <numerusform>{n:,} Bilder lassen sich nicht prüfen</numerusform>
   </translation>
  </message>
  <message>
   <source>Export findings</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>Befunde exportieren</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} findings in {frames} to {path}</source>
   <extracomment>exported {n:,} finding in {frames} to {path} / exported {n:,} findings in {frames} to {path} [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} Befund in {frames} nach {path} exportiert</numerusform>
    <numerusform>{n:,} Befunde in {frames} nach {path} exportiert</numerusform>
   </translation>
  </message>
  <message>
   <source>the label check has found nothing</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>die Klassenprüfung hat nichts gefunden</translation>
  </message>
  <message>
   <source>the elements have changed since: checked again</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>die Elemente haben sich seither geändert: neu geprüft</translation>
  </message>
  <message>
   <source>removed point of {element}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>Punkt von {element} entfernt</translation>
  </message>
  <message>
   <source>go to a finding first (F10)</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>gehen Sie zuerst zu einem Befund (F10)</translation>
  </message>
  <message>
   <source>stopped checking the set; what was found stays</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>die Prüfung des Satzes ist angehalten; was gefunden ist, bleibt</translation>
  </message>
  <message>
   <source>the label check has found nothing in this frame</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>die Klassenprüfung hat in diesem Bild nichts gefunden</translation>
  </message>
  <message>
   <source>nothing found</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>nichts gefunden</translation>
  </message>
  <message>
   <source>no remedy is known: {reason}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>keine Abhilfe bekannt: {reason}</translation>
  </message>
  <message>
   <source>cameras opened here before are not opened again: {why}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>hier zuvor geöffnete Kameras werden nicht wieder geöffnet: {why}</translation>
  </message>
  <message>
   <source>Open a video</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Video öffnen</translation>
  </message>
  <message>
   <source>One frame every</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Ein Bild alle</translation>
  </message>
  <message>
   <source>The first frame of every scene</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Das erste Bild jeder Szene</translation>
  </message>
  <message>
   <source>Looks through the whole video for cuts; this takes a while</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Sucht im ganzen Video nach Schnitten; das dauert eine Weile</translation>
  </message>
  <message>
   <source>Field</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, the field american_football, the menus]</extracomment>
   <translation>Feld</translation>
  </message>
  <message>
   <source>Reading {file}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>{file} wird gelesen</translation>
  </message>
  <message>
   <source>Looking for cuts in {file}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>In {file} werden Schnitte gesucht</translation>
  </message>
  <message>
   <source>Pictures</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Bilder</translation>
  </message>
  <message>
   <source>Videos</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Videos</translation>
  </message>
  <message>
   <source>Nothing is extracted; “Keep this video frame” writes a picture.</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Es wird nichts herausgeschrieben; „Dieses Videobild behalten“ schreibt ein Bild.</translation>
  </message>
  <message>
   <source>cameras opened here before are not there any more: {paths}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>hier zuvor geöffnete Kameras sind nicht mehr da: {paths}</translation>
  </message>
  <message>
   <source>this frame is a picture already</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>dieses Bild ist schon eine Bilddatei</translation>
  </message>
  <message>
   <source>kept as {path}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>als {path} behalten</translation>
  </message>
  <message>
   <source>the sample comes with the source, not here</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/window/tour.py]</extracomment>
   <translation>das Beispiel kommt mit dem Quelltext, nicht hier</translation>
  </message>
  <message>
   <source>your own copy, in {folder}; load its cameras from the menu Camera</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Ihre eigene Kopie, in {folder}; laden Sie ihre Kameras aus dem Menü Kamera</translation>
  </message>
  <message>
   <source>Load a folder of cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Einen Ordner mit Kameras laden</translation>
  </message>
  <message>
   <source>Load cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Kameras laden</translation>
  </message>
  <message>
   <source>Cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Kameras</translation>
  </message>
  <message>
   <source>Open a folder of pictures</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Einen Ordner mit Bildern öffnen</translation>
  </message>
  <message>
   <source>Open a picture</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Ein Bild öffnen</translation>
  </message>
  <message>
   <source>Open a second annotator's folder</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>Den Ordner eines zweiten Annotators öffnen</translation>
  </message>
  <message>
   <source>{width} x {height} px, without the legend</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{width} x {height} px, ohne Legende</translation>
  </message>
  <message>
   <source>{width} x {height} px, too large: choose a smaller scale or SVG</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{width} x {height} px, zu groß: wählen Sie einen kleineren Maßstab oder SVG</translation>
  </message>
  <message>
   <source>PNG: pixels, nothing is lost</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>PNG: Pixel, ohne Verlust</translation>
  </message>
  <message>
   <source>JPEG: pixels, small</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>JPEG: Pixel, klein</translation>
  </message>
  <message>
   <source>SVG: lines and text stay sharp</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>SVG: Linien und Text bleiben scharf</translation>
  </message>
  <message>
   <source>Picture (*{suffix})</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Bild (*{suffix})</translation>
  </message>
  <message>
   <source>Save overlay picture</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Bild mit Überlagerung speichern</translation>
  </message>
  <message>
   <source>Px of the result per px of the picture; lines and text grow with it</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Px des Ergebnisses je Px des Bildes; Linien und Text wachsen mit</translation>
  </message>
  <message>
   <source>Explain colours, dashes and marks below the picture</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Farben, Striche und Zeichen unter dem Bild erklären</translation>
  </message>
  <message>
   <source>&amp;Kind</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>&amp;Art</translation>
  </message>
  <message>
   <source>&amp;Scale</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>&amp;Maßstab</translation>
  </message>
  <message>
   <source>Result</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Ergebnis</translation>
  </message>
  <message>
   <source>&amp;Legend</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>&amp;Legende</translation>
  </message>
  <message>
   <source>writing the overlay picture {path} …</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>das Bild mit Überlagerung {path} wird geschrieben …</translation>
  </message>
  <message>
   <source>open a picture first</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>öffnen Sie zuerst ein Bild</translation>
  </message>
  <message>
   <source>{path}: is the picture itself, choose another name</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{path}: ist das Bild selbst, wählen Sie einen anderen Namen</translation>
  </message>
  <message>
   <source>overlay picture written to {path}</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>Bild mit Überlagerung nach {path} geschrieben</translation>
  </message>
  <message>
   <source>waiting</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>wartet</translation>
  </message>
  <message>
   <source>begun</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>begonnen</translation>
  </message>
  <message>
   <source>done</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>fertig</translation>
  </message>
  <message>
   <source>failed</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>fehlgeschlagen</translation>
  </message>
  <message>
   <source>Match</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Spiel</translation>
  </message>
  <message>
   <source>Stadium</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Stadion</translation>
  </message>
  <message>
   <source>Start</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Beginn</translation>
  </message>
  <message>
   <source>State</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Stand</translation>
  </message>
  <message>
   <source>Frames</source>
   <extracomment>[procc_annotator/gui/commands/season.py, procc_annotator/gui/panels/film_strip.py, procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>Bilder</translation>
  </message>
  <message>
   <source>Tracked</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Verfolgt</translation>
  </message>
  <message>
   <source>On paint</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Auf Farbe</translation>
  </message>
  <message>
   <source>Failed units</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Gescheiterte Einheiten</translation>
  </message>
  <message>
   <source>Season</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Saison</translation>
  </message>
  <message>
   <source>Search: match, stadium, state</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Suche: Spiel, Stadion, Stand</translation>
  </message>
  <message>
   <source>Tracked cameras…</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Verfolgte Kameras …</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} matches</source>
   <extracomment>{n:,} match / {n:,} matches [procc_annotator/gui/commands/season.py]</extracomment>
   <translation>
    <numerusform>{n:,} Spiel</numerusform>
    <numerusform>{n:,} Spiele</numerusform>
   </translation>
  </message>
  <message>
   <source>The folder that track writes to</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Der Ordner, in den track schreibt</translation>
  </message>
  <message>
   <source>Matches</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>Spiele</translation>
  </message>
  <message>
   <source>open a season first: a folder in which videos lie, or a list of them</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>zuerst eine Saison öffnen: einen Ordner, in dem Videos liegen, oder eine Liste von ihnen</translation>
  </message>
  <message>
   <source>it is annotated by now</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>es ist inzwischen annotiert</translation>
  </message>
  <message>
   <source>it was edited since</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>es wurde seither bearbeitet</translation>
  </message>
  <message>
   <source>no frame to accept: follow the shot first (T)</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>kein Bild zu übernehmen: folgen Sie zuerst der Einstellung (T)</translation>
  </message>
  <message>
   <source>the shot is still being followed: wait for its end, or stop it (T), then accept</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>die Einstellung wird noch verfolgt: warten Sie das Ende ab oder halten Sie an (T), dann annehmen</translation>
  </message>
  <message>
   <source>no frame to accept: all that were followed are annotated</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>kein Bild zu übernehmen: alle verfolgten sind annotiert</translation>
  </message>
  <message>
   <source>every frame is annotated</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>jedes Bild ist annotiert</translation>
  </message>
  <message>
   <source>blind mode: nothing is accepted that was not clicked</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>Blindmodus: angenommen wird nichts, was nicht geklickt ist</translation>
  </message>
  <message numerus="yes">
   <source>all {n:,} frames are doubtful ({why}): look at some; Ctrl+Shift+Enter once more accepts them</source>
   <extracomment>{n:,} frame is doubtful ({why}): look at it; Ctrl+Shift+Enter once more accepts it / all {n:,} frames are doubtful ({why}): look at some; Ctrl+Shift+Enter once more accepts them [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild ist zweifelhaft ({why}): sehen Sie es an; noch einmal Strg+Umschalt+Eingabe übernimmt es</numerusform>
    <numerusform>alle {n:,} Bilder sind zweifelhaft ({why}): sehen Sie einige an; noch einmal Strg+Umschalt+Eingabe übernimmt sie</numerusform>
   </translation>
  </message>
  <message>
   <source>finding line points: {done} of {total} frames  ·  Esc stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>Linienpunkte werden gesucht: {done} von {total} Bildern  ·  Esc hält an</translation>
  </message>
  <message>
   <source>accept elements</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>Elemente übernehmen</translation>
  </message>
  <message>
   <source>take back accepted elements</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>angenommene Elemente zurücknehmen</translation>
  </message>
  <message numerus="yes">
   <source>annotated {n:,} frames</source>
   <extracomment>annotated {n:,} frame / annotated {n:,} frames [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild annotiert</numerusform>
    <numerusform>{n:,} Bilder annotiert</numerusform>
   </translation>
  </message>
  <message>
   <source>Ctrl+Z takes them back</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>Strg+Z nimmt sie zurück</translation>
  </message>
  <message numerus="yes">
   <source>taken back: {n:,} annotated frames</source>
   <extracomment>taken back: {n:,} annotated frame / taken back: {n:,} annotated frames [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>zurückgenommen: {n:,} annotiertes Bild</numerusform>
    <numerusform>zurückgenommen: {n:,} annotierte Bilder</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames left: {why}</source>
   <extracomment>{n:,} frame left: {why} / {n:,} frames left: {why} [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild gelassen: {why}</numerusform>
    <numerusform>{n:,} Bilder gelassen: {why}</numerusform>
   </translation>
  </message>
  <message>
   <source>finding line points …  Esc stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>Linienpunkte werden gesucht …  Esc hält an</translation>
  </message>
  <message>
   <source>no frame was annotated: too little of their lines is seen</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>kein Bild annotiert: zu wenig ihrer Linien ist zu sehen</translation>
  </message>
  <message>
   <source>no frame was accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>kein Bild angenommen: {why}</translation>
  </message>
  <message>
   <source>nothing was accepted that could be taken back</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>nichts Angenommenes, das zurückzunehmen wäre</translation>
  </message>
  <message>
   <source>taken back: no frame is accepted</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>zurückgenommen: kein Bild ist angenommen</translation>
  </message>
  <message>
   <source>no frame was annotated: no camera is sure</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>kein Bild annotiert: keine Kamera ist sicher</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames are not sure: Alt+PgDown goes through them, the least sure first</source>
   <extracomment>{n:,} frame is not sure: Alt+PgDown shows it / {n:,} frames are not sure: Alt+PgDown goes through them, the least sure first [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild ist nicht sicher: Alt+Bild ab zeigt es</numerusform>
    <numerusform>{n:,} Bilder sind nicht sicher: Alt+Bild ab geht sie durch, unsicherste zuerst</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} doubtful frames left: Ctrl+Shift+Enter once more accepts them</source>
   <extracomment>{n:,} doubtful frame left: Ctrl+Shift+Enter once more accepts it / {n:,} doubtful frames left: Ctrl+Shift+Enter once more accepts them [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} zweifelhaftes Bild ausgelassen: noch einmal Strg+Umschalt+Eingabe übernimmt es</numerusform>
    <numerusform>{n:,} zweifelhafte Bilder ausgelassen: noch einmal Strg+Umschalt+Eingabe übernimmt sie</numerusform>
   </translation>
  </message>
  <message>
   <source>the camera of this frame is unsure: a sure one is looked for in the shot; look at this one, accept its lines (Shift+Enter), then T follows them</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>die Kamera dieses Bildes ist unsicher: eine sichere wird in der Einstellung gesucht; sehen Sie diese an, übernehmen Sie ihre Linien (Umschalt+Eingabe), dann folgt T ihnen</translation>
  </message>
  <message>
   <source>no frame of the shot has a camera that is sure: accept the lines of one (Shift+Enter), or {advice}; then T follows it</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>kein Bild der Einstellung hat eine sichere Kamera: übernehmen Sie die Linien eines Bildes (Umschalt+Eingabe) oder {advice}; dann folgt T ihm</translation>
  </message>
  <message numerus="yes">
   <source>followed {n:,} frames, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones</source>
   <extracomment>followed {n:,} frame, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones / followed {n:,} frames, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones [procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild verfolgt, davon {doubtful:,} zweifelhaft (Alt+Bild ab); Strg+Umschalt+Eingabe nimmt die sicheren an</numerusform>
    <numerusform>{n:,} Bilder verfolgt, davon {doubtful:,} zweifelhaft (Alt+Bild ab); Strg+Umschalt+Eingabe nimmt die sicheren an</numerusform>
   </translation>
  </message>
  <message>
   <source>following: {done} of {total} frames  ·  T stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>Verfolgung: {done} von {total} Bildern  ·  T hält an</translation>
  </message>
  <message numerus="yes">
   <source>followed {n:,} frames, all of them sure; Ctrl+Shift+Enter accepts the sure ones</source>
   <extracomment>followed {n:,} frame, all of them sure; Ctrl+Shift+Enter accepts the sure ones / followed {n:,} frames, all of them sure; Ctrl+Shift+Enter accepts the sure ones [procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild verfolgt, sicher; Strg+Umschalt+Eingabe nimmt die sicheren an</numerusform>
    <numerusform>{n:,} Bilder verfolgt, alle sicher; Strg+Umschalt+Eingabe nimmt die sicheren an</numerusform>
   </translation>
  </message>
  <message>
   <source>looking for the ends of the shot …  T stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>die Enden der Einstellung werden gesucht …  T hält an</translation>
  </message>
  <message>
   <source>the shot could not be followed: {why}</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>der Einstellung ließ sich nicht folgen: {why}</translation>
  </message>
  <message>
   <source>only a video, or frames that follow one another, can be followed</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>nur einem Video oder aufeinanderfolgenden Bildern lässt sich folgen</translation>
  </message>
  <message>
   <source>blind mode: no shot is followed, its cameras would be seen</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>Blindmodus: keiner Einstellung wird gefolgt, ihre Kameras wären zu sehen</translation>
  </message>
  <message>
   <source>stopped; what was followed so far stays</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>angehalten; das bisher Verfolgte bleibt</translation>
  </message>
  <message>
   <source>stopped; nothing was followed</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>angehalten; nichts wurde verfolgt</translation>
  </message>
  <message>
   <source>Unlocking shows cameras, ghosts and the fit to everybody who annotates it. It is recorded with the dataset that {author} unlocked it, and when.</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Das Aufheben zeigt allen, die ihn annotieren, Kameras, Geister und die Anpassung. Beim Datensatz wird vermerkt, dass {author} es tat, und wann.</translation>
  </message>
  <message>
   <source>Unlocking shows cameras, ghosts and the fit to you; for others it was not locked. It is recorded with the dataset that {author} unlocked it, and when.</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Das Aufheben zeigt Ihnen Kameras, Geister und die Anpassung; für andere war er nicht festgelegt. Beim Datensatz wird vermerkt, dass {author} es tat, und wann.</translation>
  </message>
  <message>
   <source>blind mode leaves out {n} on frames that are not committed</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>der Blindmodus lässt {n} zu nicht abgegebenen Bildern aus</translation>
  </message>
  <message>
   <source>{frame}: no verdict on {source} any more</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{frame}: kein Urteil über {source} mehr</translation>
  </message>
  <message>
   <source>Note on the verdict</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Notiz zum Urteil</translation>
  </message>
  <message>
   <source>What is wrong here:</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Was ist hier falsch:</translation>
  </message>
  <message>
   <source>Export verdicts</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>Urteile exportieren</translation>
  </message>
  <message>
   <source>blind: no frame that is committed has a verdict</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>blind: kein abgegebenes Bild hat ein Urteil</translation>
  </message>
  <message>
   <source>no frame has a verdict yet: mark one first</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>noch hat kein Bild ein Urteil: geben Sie zuerst eines ab</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} verdicts to {path}</source>
   <extracomment>exported {n:,} verdict to {path} / exported {n:,} verdicts to {path} [procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>
    <numerusform>{n:,} Urteil nach {path} exportiert</numerusform>
    <numerusform>{n:,} Urteile nach {path} exportiert</numerusform>
   </translation>
  </message>
  <message>
   <source>mark the frame first: camera wrong, labels wrong or fine</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>urteilen Sie zuerst über das Bild: Kamera falsch, Annotation falsch oder OK</translation>
  </message>
  <message>
   <source>not everything could be saved: the figures are of the last saved state</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>nicht alles ließ sich speichern: die Zahlen gelten dem zuletzt gespeicherten Stand</translation>
  </message>
  <message>
   <source>{source} follows the clicks: a verdict is on a camera that was loaded</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{source} folgt den Klicks: ein Urteil gilt einer geladenen Kamera</translation>
  </message>
  <message>
   <source>{source} is worked out here: a verdict is on a camera that was loaded</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{source} entsteht hier: ein Urteil gilt einer geladenen Kamera</translation>
  </message>
  <message>
   <source>There is no earlier version of this frame.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Es gibt keine frühere Fassung dieses Bildes.</translation>
  </message>
  <message>
   <source>Compared with now: {changes}. What differs: {elements}.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Verglichen mit jetzt: {changes}. Verschieden: {elements}.</translation>
  </message>
  <message>
   <source>cannot be read</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>unlesbar</translation>
  </message>
  <message>
   <source>empty</source>
   <comment>a version</comment>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>leer</translation>
  </message>
  <message>
   <source>as now</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>wie jetzt</translation>
  </message>
  <message>
   <source>other elements</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>andere Elemente</translation>
  </message>
  <message>
   <source>points moved</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Punkte verschoben</translation>
  </message>
  <message>
   <source>This is what the frame holds now.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Das enthält das Bild jetzt.</translation>
  </message>
  <message>
   <source>Compared with now: the same points in another order of elements.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Verglichen mit jetzt: dieselben Punkte in anderer Reihenfolge der Elemente.</translation>
  </message>
  <message>
   <source>restore an earlier version</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>eine frühere Fassung zurückholen</translation>
  </message>
  <message>
   <source>Earlier versions</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Frühere Fassungen</translation>
  </message>
  <message>
   <source>Restore</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>Zurückholen</translation>
  </message>
  <message>
   <source>%d %b %Y, %H:%M:%S</source>
   <comment>a moment; the month as %b is English, as %m a number</comment>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>%d.%m.%Y, %H:%M:%S</translation>
  </message>
  <message>
   <source>{n} more</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>{n} weitere</translation>
  </message>
  <message>
   <source>the earlier version is back; undo takes it away again</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>die frühere Fassung ist zurück; Rückgängig nimmt sie wieder weg</translation>
  </message>
  <message>
   <source>the earlier version is back; what could not be read stays a version</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>die frühere Fassung ist wieder da; was nicht lesbar war, bleibt als Fassung erhalten</translation>
  </message>
  <message>
   <source>the frame was changed elsewhere: look at it, then restore again</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>das Bild wurde anderswo geändert: sehen Sie es an, dann holen Sie es noch einmal zurück</translation>
  </message>
  <message>
   <source>Frames of one instant from different cameras are one group. Their names tell which, by a pattern: &lt;b&gt;{instant}&lt;/b&gt; stands for when a frame was taken, &lt;b&gt;{view}&lt;/b&gt; for the camera, all else for itself. A regular expression with &lt;b&gt;(?P&amp;lt;instant&amp;gt;…)&lt;/b&gt; and &lt;b&gt;(?P&amp;lt;view&amp;gt;…)&lt;/b&gt; does it, too.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Bilder eines Augenblicks aus verschiedenen Kameras bilden eine Gruppe. Ihre Namen sagen, welche, nach einem Muster: &lt;b&gt;{instant}&lt;/b&gt; steht dafür, wann ein Bild entstand, &lt;b&gt;{view}&lt;/b&gt; für die Kamera, alles andere für sich selbst. Ein regulärer Ausdruck mit &lt;b&gt;(?P&amp;lt;instant&amp;gt;…)&lt;/b&gt; und &lt;b&gt;(?P&amp;lt;view&amp;gt;…)&lt;/b&gt; tut es auch.</translation>
  </message>
  <message>
   <source>No pattern was found that fits these names: write one.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Kein passendes Muster für diese Namen gefunden: schreiben Sie eines.</translation>
  </message>
  <message>
   <source>What it says now is lost, with everything else that is written in it.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Was jetzt darin steht, geht verloren, samt allem anderen.</translation>
  </message>
  <message>
   <source>Instant</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Augenblick</translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} groups of {least} to {most}</source>
   <extracomment>{frames} in {n:,} group of {least} to {most} / {frames} in {n:,} groups of {least} to {most} [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{frames} in {n:,} Gruppe von {least} bis {most}</numerusform>
    <numerusform>{frames} in {n:,} Gruppen von {least} bis {most}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{frames} of {n:,} instants</source>
   <extracomment>{frames} of {n:,} instant / {frames} of {n:,} instants [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{frames} aus {n:,} Augenblick</numerusform>
    <numerusform>{frames} aus {n:,} Augenblicken</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames, none grouped.</source>
   <extracomment>{n:,} frame, none grouped. / {n:,} frames, none grouped. [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild, nicht gruppiert.</numerusform>
    <numerusform>{n:,} Bilder, keines gruppiert.</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} groups</source>
   <extracomment>{frames} in {n:,} group / {frames} in {n:,} groups [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{frames} in {n:,} Gruppe</numerusform>
    <numerusform>{frames} in {n:,} Gruppen</numerusform>
   </translation>
  </message>
  <message>
   <source>This name does not fit the pattern: the frame stands alone</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Dieser Name passt nicht zum Muster: das Bild steht allein</translation>
  </message>
  <message>
   <source>{file} groups {sizes} from now on</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>{file} gruppiert ab jetzt {sizes}</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} instants with one frame only</source>
   <extracomment>{n:,} instant with one frame only / {n:,} instants with one frame only [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} Augenblick mit nur einem Bild</numerusform>
    <numerusform>{n:,} Augenblicke mit nur einem Bild</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} names do not fit (last in the table)</source>
   <extracomment>{n:,} name does not fit (last in the table) / {n:,} names do not fit (last in the table) [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} Name passt nicht (zuletzt in der Tabelle)</numerusform>
    <numerusform>{n:,} Namen passen nicht (zuletzt in der Tabelle)</numerusform>
   </translation>
  </message>
  <message>
   <source>Group views</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Ansichten gruppieren</translation>
  </message>
  <message>
   <source>{file} is there already: {sizes}.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>{file} gibt es schon: {sizes}.</translation>
  </message>
  <message>
   <source>Write {file}</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>{file} schreiben</translation>
  </message>
  <message>
   <source>Keep these groups in the dataset's folder</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Diese Gruppen im Ordner des Datensatzes behalten</translation>
  </message>
  <message>
   <source>Groups of frames</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Gruppen von Bildern</translation>
  </message>
  <message>
   <source>Pattern of the frames' names</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>Muster der Bildnamen</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements, symmetries: {turns}</source>
   <extracomment>{n} element, symmetries: {turns} / {n} elements, symmetries: {turns} [procc_annotator/gui/field_preview.py]</extracomment>
   <translation>
    <numerusform>{n} Element, Symmetrien: {turns}</numerusform>
    <numerusform>{n} Elemente, Symmetrien: {turns}</numerusform>
   </translation>
  </message>
  <message>
   <source>There is no field to show yet.</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>Es gibt noch kein Feld zu zeigen.</translation>
  </message>
  <message>
   <source>{dimension}: {value:.10g} m (the rules allow {least:g} to {most:g} m)</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>{dimension}: {value:.10g} m (die Regeln erlauben {least:g} bis {most:g} m)</translation>
  </message>
  <message>
   <source>... and {n} more</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>... und {n} weitere</translation>
  </message>
  <message>
   <source>none</source>
   <extracomment>[procc_annotator/gui/field_preview.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>keine</translation>
  </message>
  <message>
   <source>what is held down in the picture</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>was im Bild gehalten wird</translation>
  </message>
  <message>
   <source>Usual</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Üblich</translation>
  </message>
  <message>
   <source>Left-handed</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Linkshändig</translation>
  </message>
  <message>
   <source>Like CVAT</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Wie CVAT</translation>
  </message>
  <message>
   <source>Like labelme</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Wie labelme</translation>
  </message>
  <message>
   <source>Wheel</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Mausrad</translation>
  </message>
  <message>
   <source>zoom at the cursor</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>am Mauszeiger vergrößern</translation>
  </message>
  <message>
   <source>Two fingers</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Zwei Finger</translation>
  </message>
  <message>
   <source>pan; pinched, zoom</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>verschieben; gespreizt vergrößern</translation>
  </message>
  <message>
   <source>Shift + wheel</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Umschalt + Mausrad</translation>
  </message>
  <message>
   <source>pan sideways, as a tilted wheel does</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>seitwärts verschieben, wie ein Kipprad</translation>
  </message>
  <message>
   <source>Space + drag</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Leertaste + ziehen</translation>
  </message>
  <message>
   <source>pan</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>verschieben</translation>
  </message>
  <message>
   <source>Middle button</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Mittlere Taste</translation>
  </message>
  <message>
   <source>Hold X</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>X halten</translation>
  </message>
  <message>
   <source>hide all overlays</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>alle Überlagerungen ausblenden</translation>
  </message>
  <message>
   <source>Hold Z</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Z halten</translation>
  </message>
  <message>
   <source>loupe: eight times the picture's pixels</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Lupe: achtfache Bildpixel</translation>
  </message>
  <message>
   <source>Hold ,</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>, halten</translation>
  </message>
  <message>
   <source>look at the compared camera source</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>die verglichene Kameraquelle ansehen</translation>
  </message>
  <message>
   <source>Tap ,</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>, tippen</translation>
  </message>
  <message>
   <source>judge with the compared source, compare with this one</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>mit der verglichenen Quelle beurteilen, mit dieser vergleichen</translation>
  </message>
  <message>
   <source>Hold Ctrl</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Strg halten</translation>
  </message>
  <message>
   <source>click off the line: no snapping</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>neben die Linie klicken: kein Einrasten</translation>
  </message>
  <message>
   <source>Ctrl+Alt + drag a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Strg+Alt + Linie ziehen</translation>
  </message>
  <message>
   <source>camera: it follows, the place stays as a peg</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Kamera: sie folgt, die Stelle bleibt als Pflock</translation>
  </message>
  <message>
   <source>Ctrl+Alt + click a peg</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Strg+Alt + Pflock klicken</translation>
  </message>
  <message>
   <source>camera: take the peg away</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Kamera: den Pflock wegnehmen</translation>
  </message>
  <message>
   <source>Arrows</source>
   <extracomment>[procc_annotator/gui/keymap.py, procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Pfeiltasten</translation>
  </message>
  <message>
   <source>crosshair: the keys point; chosen points are moved instead</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Fadenkreuz: die Tasten zeigen; gewählte Punkte werden statt dessen bewegt</translation>
  </message>
  <message>
   <source>Space at the crosshair</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Leertaste am Fadenkreuz</translation>
  </message>
  <message>
   <source>what a click does there (with Ctrl: no snapping)</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>was ein Klick dort tut (mit Strg: ohne Einrasten)</translation>
  </message>
  <message>
   <source>Right button</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Rechte Taste</translation>
  </message>
  <message>
   <source>menu of what is under the cursor</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Menü zu dem, was unter dem Mauszeiger ist</translation>
  </message>
  <message>
   <source>Enter</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Eingabe</translation>
  </message>
  <message>
   <source>accept the current ghost</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>den aktuellen Geist annehmen</translation>
  </message>
  <message>
   <source>Shift+Enter</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Umschalt+Eingabe</translation>
  </message>
  <message>
   <source>accept all ghosts</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>alle Geister annehmen</translation>
  </message>
  <message>
   <source>Click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Klick</translation>
  </message>
  <message>
   <source>draw: add a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Zeichnen: einen Punkt hinzufügen</translation>
  </message>
  <message>
   <source>Double-click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Doppelklick</translation>
  </message>
  <message>
   <source>draw: finish</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Zeichnen: beenden</translation>
  </message>
  <message>
   <source>Drag a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Punkt ziehen</translation>
  </message>
  <message>
   <source>edit: move it</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Bearbeiten: ihn verschieben</translation>
  </message>
  <message>
   <source>Shift+click a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Umschalt+Klick auf Punkt</translation>
  </message>
  <message>
   <source>edit: choose several</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Bearbeiten: mehrere wählen</translation>
  </message>
  <message>
   <source>Drag on empty ground</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Auf freiem Grund ziehen</translation>
  </message>
  <message>
   <source>edit: choose the points inside</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Bearbeiten: die Punkte darin wählen</translation>
  </message>
  <message>
   <source>Drag a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Linie ziehen</translation>
  </message>
  <message>
   <source>edit: move the element, unless elements are pinned</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Bearbeiten: das Element verschieben, außer es ist festgehalten</translation>
  </message>
  <message>
   <source>Alt+click a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Alt+Klick auf Linie</translation>
  </message>
  <message>
   <source>edit: insert a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Bearbeiten: einen Punkt einfügen</translation>
  </message>
  <message>
   <source>Alt+Shift+click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Alt+Umschalt+Klick</translation>
  </message>
  <message>
   <source>edit: remove the point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Bearbeiten: den Punkt entfernen</translation>
  </message>
  <message>
   <source>Click or drag on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Streifen klicken oder ziehen</translation>
  </message>
  <message>
   <source>go to a frame</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>zu einem Bild gehen</translation>
  </message>
  <message>
   <source>Wheel on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Mausrad auf dem Streifen</translation>
  </message>
  <message>
   <source>zoom; with Shift, scroll</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>vergrößern; mit Umschalt rollen</translation>
  </message>
  <message>
   <source>Shift+drag on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Umschalt+ziehen auf dem Streifen</translation>
  </message>
  <message>
   <source>mark a stretch (a double click lets go of it)</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>einen Abschnitt markieren (Doppelklick hebt ihn auf)</translation>
  </message>
  <message>
   <source>expected an object with "actions" and "elements"</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>erwartet: ein Objekt mit "actions" und "elements"</translation>
  </message>
  <message>
   <source>"actions" and "elements": expected objects</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>"actions" und "elements": erwartet sind Objekte</translation>
  </message>
  <message>
   <source>{place}: {value!r} is no key; expected one like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place}: {value!r} ist keine Taste; erwartet ist eine wie {one}</translation>
  </message>
  <message>
   <source>{place}: expected a list of keys, like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place}: erwartet ist eine Liste von Tasten wie {one}</translation>
  </message>
  <message>
   <source>Panels</source>
   <extracomment>[procc_annotator/gui/main_window.py]</extracomment>
   <translation>Bereiche</translation>
  </message>
  <message>
   <source>Choose another place…</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Anderen Ort wählen…</translation>
  </message>
  <message>
   <source>Save copies to…</source>
   <extracomment>[procc_annotator/gui/messages.py, the action save_copies]</extracomment>
   <translation>Kopien sichern in…</translation>
  </message>
  <message>
   <source>Copy details</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Einzelheiten kopieren</translation>
  </message>
  <message>
   <source>Show the next</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Nächstes zeigen</translation>
  </message>
  <message>
   <source>{what} is there already, and says something else.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{what} gibt es schon, und es steht etwas anderes darin.</translation>
  </message>
  <message numerus="yes">
   <source>{n} comments on this frame are not settled.</source>
   <extracomment>{n} comment on this frame is not settled. / {n} comments on this frame are not settled. [procc_annotator/gui/messages.py]</extracomment>
   <translation>
    <numerusform>{n} Kommentar zu diesem Bild ist nicht erledigt.</numerusform>
    <numerusform>{n} Kommentare zu diesem Bild sind nicht erledigt.</numerusform>
   </translation>
  </message>
  <message>
   <source>A tick in the Review panel settles a comment.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Ein Häkchen im Bereich „Durchsicht“ erledigt einen Kommentar.</translation>
  </message>
  <message>
   <source>{n:,} of {total:,} frames are not done.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{n:,} von {total:,} Bildern sind nicht fertig.</translation>
  </message>
  <message numerus="yes">
   <source>{n} frames are not saved, and saving failed again just now.</source>
   <extracomment>{n} frame is not saved, and saving failed again just now. / {n} frames are not saved, and saving failed again just now. [procc_annotator/gui/messages.py]</extracomment>
   <translation>
    <numerusform>{n} Bild ist nicht gespeichert, und das Speichern misslang eben noch einmal.</numerusform>
    <numerusform>{n} Bilder sind nicht gespeichert, und das Speichern misslang eben noch einmal.</numerusform>
   </translation>
  </message>
  <message>
   <source>Show what is in the file; undo brings your version back</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Zeigen, was in der Datei steht; Rückgängig bringt Ihre Fassung zurück</translation>
  </message>
  <message>
   <source>Write what you see on screen over the file</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Was Sie sehen, über die Datei schreiben</translation>
  </message>
  <message>
   <source>Export all</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Alle exportieren</translation>
  </message>
  <message>
   <source>Done only</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Nur fertige</translation>
  </message>
  <message>
   <source>Dismiss this message</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Diese Meldung wegnehmen</translation>
  </message>
  <message>
   <source>Reload theirs</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Fremde neu laden</translation>
  </message>
  <message>
   <source>Overwrite with mine</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Mit eigener überschreiben</translation>
  </message>
  <message>
   <source>Delete {what}?</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{what} löschen?</translation>
  </message>
  <message>
   <source>Keep it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Behalten</translation>
  </message>
  <message>
   <source>Delete</source>
   <extracomment>[procc_annotator/gui/messages.py, procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Löschen</translation>
  </message>
  <message>
   <source>Replace it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Ersetzen</translation>
  </message>
  <message>
   <source>Do not approve</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Nicht freigeben</translation>
  </message>
  <message>
   <source>Approve</source>
   <extracomment>[procc_annotator/gui/messages.py, procc_annotator/gui/panels/review.py, the action approve]</extracomment>
   <translation>Freigeben</translation>
  </message>
  <message>
   <source>Keep it locked</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Festgelegt lassen</translation>
  </message>
  <message>
   <source>Unlock, and record it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Aufheben und vermerken</translation>
  </message>
  <message>
   <source>Stay</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Bleiben</translation>
  </message>
  <message>
   <source>Close and lose them</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Schließen und verlieren</translation>
  </message>
  <message>
   <source>Open a second annotator's folder (menu File) to compare the clicks of both.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Öffnen Sie den Ordner eines zweiten Annotators (Menü Datei), um die Klicks beider zu vergleichen.</translation>
  </message>
  <message>
   <source>Apart: the two share (almost) no stretch of this element, which is no agreement. Was its class swapped with a neighbour's?</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Getrennt: beide haben (fast) keinen Abschnitt dieses Elements gemeinsam, das ist keine Übereinstimmung. Wurde seine Klasse mit einer Nachbarklasse vertauscht?</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} clicks compared</source>
   <extracomment>{n:,} click compared / {n:,} clicks compared [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} Klick verglichen</numerusform>
    <numerusform>{n:,} Klicks verglichen</numerusform>
   </translation>
  </message>
  <message>
   <source>{part} of {total}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>{part} von {total}</translation>
  </message>
  <message>
   <source>apart</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>getrennt</translation>
  </message>
  <message numerus="yes">
   <source>{compared}, {n} left out: beyond the ends of what the other clicked</source>
   <extracomment>{compared}, {n} left out: beyond the ends of what the other clicked / {compared}, {n} left out: beyond the ends of what the other clicked [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{compared}, {n} ausgelassen: jenseits der Enden dessen, was der andere klickte</numerusform>
    <numerusform>{compared}, {n} ausgelassen: jenseits der Enden dessen, was der andere klickte</numerusform>
   </translation>
  </message>
  <message>
   <source>Measuring the set…</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Der Satz wird gemessen…</translation>
  </message>
  <message>
   <source>Distances by element</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Abstände je Element</translation>
  </message>
  <message>
   <source>Close the second annotator</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Den zweiten Annotator schließen</translation>
  </message>
  <message>
   <source>The second annotator's file for this frame is unreadable: {error}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Die Datei des zweiten Annotators zu diesem Bild ist unlesbar: {error}</translation>
  </message>
  <message>
   <source>Agreement JaC at {tau:g} px: {jac:.3f}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>JaC der Übereinstimmung bei {tau:g} px: {jac:.3f}</translation>
  </message>
  <message>
   <source>No element is annotated by both in any frame.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>In keinem Bild haben beide ein Element annotiert.</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames unreadable, not compared</source>
   <extracomment>{n:,} frame unreadable, not compared / {n:,} frames unreadable, not compared [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild unlesbar, nicht verglichen</numerusform>
    <numerusform>{n:,} Bilder unlesbar, nicht verglichen</numerusform>
   </translation>
  </message>
  <message>
   <source>Median</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Median</translation>
  </message>
  <message>
   <source>Points</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Punkte</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows the score once this frame is committed.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Verborgen: im Blindmodus erscheint die Bewertung, sobald dieses Bild abgegeben ist.</translation>
  </message>
  <message>
   <source>One of the two seems to label the field turned by 180 degrees.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Einer der beiden scheint das um 180 Grad gedrehte Feld zu benennen.</translation>
  </message>
  <message>
   <source>Apart: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Getrennt: {elements}</translation>
  </message>
  <message>
   <source>Only here: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Nur hier: {elements}</translation>
  </message>
  <message>
   <source>Only there: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Nur dort: {elements}</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} clicks beyond the other's ends, left out</source>
   <extracomment>{n:,} click beyond the other's ends, left out / {n:,} clicks beyond the other's ends, left out [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} Klick jenseits der Enden des anderen, ausgelassen</numerusform>
    <numerusform>{n:,} Klicks jenseits der Enden des anderen, ausgelassen</numerusform>
   </translation>
  </message>
  <message>
   <source>Nothing to measure noise by: all elements annotated by both are apart.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Nichts, woran das Rauschen zu messen wäre: alle von beiden annotierten Elemente liegen getrennt.</translation>
  </message>
  <message numerus="yes">
   <source>Human noise over {n:,} frames: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height})</source>
   <extracomment>Human noise over {n:,} frame: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height}) / Human noise over {n:,} frames: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height}) [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>Menschliches Rauschen über {n:,} Bild: Median {median:.2f} px, 95 % innerhalb {p95:.2f} px (bei {width}x{height})</numerusform>
    <numerusform>Menschliches Rauschen über {n:,} Bilder: Median {median:.2f} px, 95 % innerhalb {p95:.2f} px (bei {width}x{height})</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>and {n} more</source>
   <extracomment>and {n} more / and {n} more [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>und {n} weiteres</numerusform>
    <numerusform>und {n} weitere</numerusform>
   </translation>
  </message>
  <message>
   <source>The second annotator has nothing for this frame.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>Der zweite Annotator hat nichts zu diesem Bild.</translation>
  </message>
  <message>
   <source>Frames of this dataset that have a camera (completeness)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Bilder dieses Datensatzes, die eine Kamera haben (Vollständigkeit)</translation>
  </message>
  <message>
   <source>Frames visited in this window whose clicks gave a camera; their JaC is of the clicks that the fit was made from.
procc-annotator calibrate fits and scores the whole set</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>In diesem Fenster besuchte Bilder, deren Klicks eine Kamera ergaben; ihr JaC gilt den Klicks, aus denen die Anpassung entstand.
procc-annotator calibrate passt den ganzen Satz an und bewertet ihn</translation>
  </message>
  <message>
   <source>Frames of this dataset that were followed through their shot and have a camera.
procc-annotator track follows a whole video and writes its cameras</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Bilder dieses Datensatzes, die durch ihre Einstellung verfolgt wurden und eine Kamera haben.
procc-annotator track verfolgt ein ganzes Video und schreibt seine Kameras</translation>
  </message>
  <message>
   <source>Yellow</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Gelb</translation>
  </message>
  <message>
   <source>Violet</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Violett</translation>
  </message>
  <message>
   <source>Blue</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Blau</translation>
  </message>
  <message>
   <source>Mint</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Mint</translation>
  </message>
  <message>
   <source>Navy</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Marineblau</translation>
  </message>
  <message>
   <source>Cyan</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Cyan</translation>
  </message>
  <message>
   <source>Switch the live fit off (Ctrl+T switches it on again)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Die laufende Anpassung ausschalten (Strg+T schaltet sie wieder ein)</translation>
  </message>
  <message>
   <source>Name of the source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Name der Quelle</translation>
  </message>
  <message>
   <source>Draw as a wireframe while another source is judged</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Als Drahtgitter zeichnen, während eine andere Quelle beurteilt wird</translation>
  </message>
  <message>
   <source>Mean JaC at {tau:.1f} px over {frames}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Mittlerer JaC bei {tau:.1f} px über {frames}</translation>
  </message>
  <message>
   <source>Unreadable (filter camera:unreadable): {names}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Unlesbar (Filter camera:unreadable): {names}</translation>
  </message>
  <message numerus="yes">
   <source>{matched} of {total}, {n} unreadable</source>
   <extracomment>{matched} of {total}, {n} unreadable / {matched} of {total}, {n} unreadable [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{matched} von {total}, {n} unlesbar</numerusform>
    <numerusform>{matched} von {total}, {n} unlesbar</numerusform>
   </translation>
  </message>
  <message>
   <source>Remove from the list; the files stay</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Aus der Liste entfernen; die Dateien bleiben</translation>
  </message>
  <message>
   <source>Forget what was followed (T follows the shot again)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Das Verfolgte vergessen (T folgt der Einstellung erneut)</translation>
  </message>
  <message>
   <source>Judge nothing, draw no camera</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Nichts beurteilen, keine Kamera zeichnen</translation>
  </message>
  <message>
   <source>Judge against {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{name} beurteilen</translation>
  </message>
  <message>
   <source>Remove {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{name} entfernen</translation>
  </message>
  <message>
   <source>Draw {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{name} zeichnen</translation>
  </message>
  <message>
   <source>Colour of {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Farbe von {name}</translation>
  </message>
  <message>
   <source>{frames} so far</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{frames} bisher</translation>
  </message>
  <message numerus="yes">
   <source>{mean}; {n:,} cameras cannot be read and take no part</source>
   <extracomment>{mean}; {n:,} camera cannot be read and takes no part / {mean}; {n:,} cameras cannot be read and take no part [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{mean}; {n:,} Kamera ist unlesbar und nimmt nicht teil</numerusform>
    <numerusform>{mean}; {n:,} Kameras sind unlesbar und nehmen nicht teil</numerusform>
   </translation>
  </message>
  <message>
   <source>{model} (ground)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{model} (Boden)</translation>
  </message>
  <message>
   <source>{model} here</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{model} hier</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames followed</source>
   <extracomment>{n:,} frame followed / {n:,} frames followed [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild verfolgt</numerusform>
    <numerusform>{n:,} Bilder verfolgt</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} opened frames</source>
   <extracomment>{n:,} opened frame / {n:,} opened frames [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{n:,} geöffnetes Bild</numerusform>
    <numerusform>{n:,} geöffnete Bilder</numerusform>
   </translation>
  </message>
  <message>
   <source>{n} of {total} ({share})</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{n} von {total} ({share})</translation>
  </message>
  <message numerus="yes">
   <source>{names} and {n:,} more</source>
   <extracomment>{names} and {n:,} more / {names} and {n:,} more [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{names} und {n:,} weitere</numerusform>
    <numerusform>{names} und {n:,} weitere</numerusform>
   </translation>
  </message>
  <message>
   <source>cannot be used here: {error}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>hier nicht zu gebrauchen: {error}</translation>
  </message>
  <message>
   <source>no camera for this frame</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>keine Kamera für dieses Bild</translation>
  </message>
  <message>
   <source>Other…</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Andere…</translation>
  </message>
  <message>
   <source>Colour of the source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Farbe der Quelle</translation>
  </message>
  <message>
   <source>Double-click or F2 gives it another name</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Doppelklick oder F2 gibt ihr einen anderen Namen</translation>
  </message>
  <message>
   <source>Blind mode hides how the sources do</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Der Blindmodus verbirgt, wie gut die Quellen sind</translation>
  </message>
  <message>
   <source>No frame has both annotated elements and a camera of this source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>Kein Bild hat zugleich annotierte Elemente und eine Kamera dieser Quelle</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} cameras</source>
   <extracomment>{n:,} camera / {n:,} cameras [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{n:,} Kamera</numerusform>
    <numerusform>{n:,} Kameras</numerusform>
   </translation>
  </message>
  <message>
   <source>none judged</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>keine beurteilen</translation>
  </message>
  <message>
   <source>several models</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>mehrere Modelle</translation>
  </message>
  <message>
   <source>soccernet (official)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py, the setting protocol]</extracomment>
   <translation>soccernet (offiziell)</translation>
  </message>
  <message>
   <source>procc (paper)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>procc (Veröffentlichung)</translation>
  </message>
  <message>
   <source>count as missed</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>als verfehlt zählen</translation>
  </message>
  <message>
   <source>are left out</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>werden ausgelassen</translation>
  </message>
  <message>
   <source>Cameras ({endings});;All files (*)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Kameras ({endings});;Alle Dateien (*)</translation>
  </message>
  <message>
   <source>Source to compare with</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Quelle zum Vergleichen</translation>
  </message>
  <message>
   <source>Compare with</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Vergleichen mit</translation>
  </message>
  <message>
   <source>{share:.0f} % within {far:g} m, over {covered:.0f} % of the picture</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>{share:.0f} % innerhalb {far:g} m, auf {covered:.0f} % des Bildes</translation>
  </message>
  <message>
   <source>No cameras loaded.
Load a folder of camera files or homographies to see them judged against your clicks.</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Keine Kameras geladen.
Laden Sie einen Ordner mit Kameradateien oder Homographien, um sie an Ihren Klicks gemessen zu sehen.</translation>
  </message>
  <message>
   <source>Load folder…</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Ordner laden…</translation>
  </message>
  <message>
   <source>Load file…</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Datei laden…</translation>
  </message>
  <message>
   <source>Read as</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Gelesen als</translation>
  </message>
  <message>
   <source>Protocol</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py, the menus, the setting protocol]</extracomment>
   <translation>Protokoll</translation>
  </message>
  <message>
   <source>Off the ground</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Über dem Boden</translation>
  </message>
  <message>
   <source>This frame: {notice}</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Dieses Bild: {notice}</translation>
  </message>
  <message>
   <source>⚠ This frame's camera cannot be used: {error}</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>⚠ Die Kamera dieses Bildes ist nicht zu gebrauchen: {error}</translation>
  </message>
  <message>
   <source>Held against the active source: comma, split view, disagreement</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Wird der aktiven Quelle gegenübergestellt: Komma, geteilte Ansicht, Abweichung</translation>
  </message>
  <message>
   <source>min</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>min</translation>
  </message>
  <message>
   <source>median</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Median</translation>
  </message>
  <message>
   <source>max</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>max</translation>
  </message>
  <message>
   <source>on the ground, m</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>am Boden, m</translation>
  </message>
  <message>
   <source>in the picture, px</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>im Bild, px</translation>
  </message>
  <message>
   <source>A folder with one camera file a frame</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Ein Ordner mit einer Kameradatei je Bild</translation>
  </message>
  <message>
   <source>A zip archive of cameras, or the camera of one frame</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Ein Zip-Archiv mit Kameras, oder die Kamera eines Bildes</translation>
  </message>
  <message>
   <source>How the files loaded next are read</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Wie die als Nächstes geladenen Dateien gelesen werden</translation>
  </message>
  <message>
   <source>soccernet: the official evaluation with its quirks
procc: the paper's definition, closed circles and fine curves</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>soccernet: die offizielle Auswertung mit ihren Eigenheiten
procc: die Definition der Veröffentlichung, geschlossene Kreise und feine Kurven</translation>
  </message>
  <message>
   <source>A homography knows the ground only: how posts and crossbars count for it</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Eine Homographie kennt nur den Boden: wie Pfosten und Latten für sie zählen</translation>
  </message>
  <message>
   <source>Between the two points on the ground that a pixel means</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Zwischen den beiden Punkten am Boden, die ein Pixel meint</translation>
  </message>
  <message>
   <source>From a pixel to where the compared camera shows its ground point</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>Von einem Pixel dorthin, wo die verglichene Kamera seinen Bodenpunkt zeigt</translation>
  </message>
  <message>
   <source>annotated</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py, procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>annotiert</translation>
  </message>
  <message>
   <source>unconfirmed</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>unbestätigt</translation>
  </message>
  <message>
   <source>not visible</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>nicht sichtbar</translation>
  </message>
  <message>
   <source>next</source>
   <comment>element</comment>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>als Nächstes</translation>
  </message>
  <message>
   <source>Not annotated in this frame</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>In diesem Bild nicht annotiert</translation>
  </message>
  <message>
   <source>Annotated, but not judged: no camera is shown, or it takes no part in the evaluation</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Annotiert, aber nicht beurteilt: keine Kamera wird gezeigt, oder es nimmt an der Auswertung nicht teil</translation>
  </message>
  <message>
   <source>Copied; it does not count until it is touched or confirmed</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Kopiert; es zählt erst, wenn es berührt oder bestätigt ist</translation>
  </message>
  <message>
   <source>Passes: all its points are closer than tau to the projection</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Besteht: alle seine Punkte sind der Projektion näher als tau</translation>
  </message>
  <message>
   <source>Too far: at least one point is tau or more away (false positive)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Zu weit: mindestens ein Punkt ist tau oder mehr entfernt (falsch positiv)</translation>
  </message>
  <message>
   <source>The camera projects it, it is not annotated (false positive)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Die Kamera projiziert es, es ist nicht annotiert (falsch positiv)</translation>
  </message>
  <message>
   <source>Annotated, the camera does not project it (false negative)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Annotiert, die Kamera projiziert es nicht (falsch negativ)</translation>
  </message>
  <message>
   <source>Marked as not visible in this frame</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Jemand sagte, dass es in diesem Bild nicht zu sehen ist</translation>
  </message>
  <message>
   <source>To be annotated next, as on the field map and in the picture</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>Als Nächstes zu annotieren, wie auf der Feldkarte und im Bild</translation>
  </message>
  <message>
   <source>{title} (unknown class)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>{title} (unbekannte Klasse)</translation>
  </message>
  <message>
   <source>Without geometry</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Ohne Geometrie</translation>
  </message>
  <message>
   <source>Unknown to the field (unknown classes)</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Dem Feld unbekannt (unbekannte Klassen)</translation>
  </message>
  <message>
   <source>Find an element</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Element suchen</translation>
  </message>
  <message>
   <source>No element matches “{query}”.
Esc clears the search.</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Kein Element passt zu „{query}“.
Esc leert die Suche.</translation>
  </message>
  <message>
   <source>Annotated points</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Annotierte Punkte</translation>
  </message>
  <message>
   <source>{title}
Class in files: {name}</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>{title}
Klasse in Dateien: {name}</translation>
  </message>
  <message>
   <source>Elements</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Elemente</translation>
  </message>
  <message>
   <source>Key</source>
   <comment>keyboard</comment>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Taste</translation>
  </message>
  <message>
   <source>Pts</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>Pkt.</translation>
  </message>
  <message>
   <source>Status</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Status</translation>
  </message>
  <message>
   <source>Annotating it next helps most: the projection is then known to {after:.1f} px instead of {before:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>Es als Nächstes zu annotieren bringt am meisten: die Projektion ist dann auf {after:.1f} px statt {before:.1f} px bekannt</translation>
  </message>
  <message>
   <source>Field map</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Feldkarte</translation>
  </message>
  <message>
   <source>The arrows choose elements</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>Die Pfeiltasten wählen Elemente</translation>
  </message>
  <message>
   <source>far</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>fern</translation>
  </message>
  <message>
   <source>right</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>rechts</translation>
  </message>
  <message>
   <source>near</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>nah</translation>
  </message>
  <message>
   <source>left</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>links</translation>
  </message>
  <message>
   <source>Next: {title}, {before:.1f} → {after:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>Als Nächstes: {title}, {before:.1f} → {after:.1f} px</translation>
  </message>
  <message>
   <source>Click an element</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>Element anklicken</translation>
  </message>
  <message>
   <source>{shown:,} of {frames}</source>
   <extracomment>[procc_annotator/gui/panels/film_strip.py, procc_annotator/gui/panels/frame_delegate.py, procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>{shown:,} von {frames}</translation>
  </message>
  <message>
   <source>Show all frames</source>
   <extracomment>[procc_annotator/gui/panels/film_strip.py]</extracomment>
   <translation>Alle Bilder zeigen</translation>
  </message>
  <message>
   <source>Error</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>Fehler</translation>
  </message>
  <message>
   <source>Warning</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>Warnung</translation>
  </message>
  <message>
   <source>Hint</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>Hinweis</translation>
  </message>
  <message>
   <source>Nothing found in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>In diesem Bild wurde nichts gefunden.</translation>
  </message>
  <message numerus="yes">
   <source>Nothing found in {n:,} frames.</source>
   <extracomment>Nothing found in {n:,} frame. / Nothing found in {n:,} frames. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>In {n:,} Bild nichts gefunden.</numerusform>
    <numerusform>In {n:,} Bildern nichts gefunden.</numerusform>
   </translation>
  </message>
  <message>
   <source>No frames.
Open a folder of pictures to check their labels.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Keine Bilder.
Öffnen Sie einen Ordner mit Bildern, um ihre Klassen zu prüfen.</translation>
  </message>
  <message>
   <source>Nothing is annotated in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>In diesem Bild ist nichts annotiert.</translation>
  </message>
  <message>
   <source>No problems so far.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Bisher keine Probleme.</translation>
  </message>
  <message numerus="yes">
   <source>Nothing found but {n:,} ignored findings.</source>
   <extracomment>Nothing found but {n:,} ignored finding. / Nothing found but {n:,} ignored findings. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>Nichts gefunden außer {n:,} übergangenem Befund.</numerusform>
    <numerusform>Nichts gefunden außer {n:,} übergangenen Befunden.</numerusform>
   </translation>
  </message>
  <message>
   <source>Blind: findings that need a camera wait until this frame is committed (Ctrl+Enter).</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Blind: Befunde, die eine Kamera brauchen, warten, bis dieses Bild abgegeben ist (Strg+Eingabe).</translation>
  </message>
  <message>
   <source>The live fit is off: the full check needs it.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Die laufende Anpassung ist aus: die volle Prüfung braucht sie.</translation>
  </message>
  <message>
   <source>Full check needs a camera: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Die volle Prüfung braucht eine Kamera: {why}.</translation>
  </message>
  <message>
   <source>Blind: only committed frames are checked with a camera.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Blind: nur abgegebene Bilder werden mit einer Kamera geprüft.</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames cannot be checked, such as {name}: {why}</source>
   <extracomment>{n:,} frame cannot be checked, such as {name}: {why} / {n:,} frames cannot be checked, such as {name}: {why} [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} Bild lässt sich nicht prüfen, etwa {name}: {why}</numerusform>
    <numerusform>{n:,} Bilder lassen sich nicht prüfen, etwa {name}: {why}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>The set is not checked yet; {n:,} frames checked so far.</source>
   <extracomment>The set is not checked yet; {n:,} frame checked so far. / The set is not checked yet; {n:,} frames checked so far. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>Der Satz ist noch nicht geprüft; bisher {n:,} Bild angesehen.</numerusform>
    <numerusform>Der Satz ist noch nicht geprüft; bisher {n:,} Bilder angesehen.</numerusform>
   </translation>
  </message>
  <message>
   <source>List the findings of all checked frames, errors first, or of this frame</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Die Befunde aller geprüften Bilder, Fehler zuerst, oder die dieses Bildes aufführen</translation>
  </message>
  <message>
   <source>Frames checked</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Geprüfte Bilder</translation>
  </message>
  <message>
   <source>Checking this frame…</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Dieses Bild wird geprüft…</translation>
  </message>
  <message>
   <source>Checking the set…</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Der Satz wird geprüft…</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} errors</source>
   <extracomment>{n:,} error / {n:,} errors [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} Fehler</numerusform>
    <numerusform>{n:,} Fehler</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} warnings</source>
   <extracomment>{n:,} warning / {n:,} warnings [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} Warnung</numerusform>
    <numerusform>{n:,} Warnungen</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} hints</source>
   <extracomment>{n:,} hint / {n:,} hints [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} Hinweis</numerusform>
    <numerusform>{n:,} Hinweise</numerusform>
   </translation>
  </message>
  <message>
   <source>Check the whole set</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action check_set]</extracomment>
   <translation>Ganzen Satz prüfen</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} more are not listed: switch the signs above on.</source>
   <extracomment>{n:,} more is not listed: switch the signs above on. / {n:,} more are not listed: switch the signs above on. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} weiterer ist nicht aufgeführt: schalten Sie die Zeichen oben ein.</numerusform>
    <numerusform>{n:,} weitere sind nicht aufgeführt: schalten Sie die Zeichen oben ein.</numerusform>
   </translation>
  </message>
  <message>
   <source>Do not show it again until the points of its elements change</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action ignore_finding]</extracomment>
   <translation>Ihn nicht mehr zeigen, bis sich die Punkte seiner Elemente ändern</translation>
  </message>
  <message>
   <source>Findings</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Befunde</translation>
  </message>
  <message>
   <source>Whole set</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Ganzer Satz</translation>
  </message>
  <message>
   <source>Look for wrong labels in every annotated frame</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action check_set]</extracomment>
   <translation>In jedem annotierten Bild nach falschen Klassen suchen</translation>
  </message>
  <message>
   <source>Write the findings of all checked frames as CSV</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>Die Befunde aller geprüften Bilder als CSV schreiben</translation>
  </message>
  <message>
   <source>{findings}; click to list them or not</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>{findings}; klicken, um sie aufzuführen oder nicht</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt;</source>
   <extracomment>{n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt; / {n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt; [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} hier übergangen. &lt;a href="restore"&gt;Wieder zeigen&lt;/a&gt;</numerusform>
    <numerusform>{n:,} hier übergangen. &lt;a href="restore"&gt;Wieder zeigen&lt;/a&gt;</numerusform>
   </translation>
  </message>
  <message>
   <source>Ignore this finding</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, procc_annotator/gui/window/menus.py, the action ignore_finding]</extracomment>
   <translation>Diesen Befund übergehen</translation>
  </message>
  <message>
   <source>Mean</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Mittel</translation>
  </message>
  <message>
   <source>Largest</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Größtes</translation>
  </message>
  <message>
   <source>Worst first; a click shows the worst point</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Schlechteste zuerst; ein Klick zeigt den schlechtesten Punkt</translation>
  </message>
  <message>
   <source>Mean distance of its points to the fitted element, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Mittlerer Abstand seiner Punkte zum angepassten Element, px des Bildes</translation>
  </message>
  <message>
   <source>Largest distance of its points to the fitted element, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Größter Abstand seiner Punkte zum angepassten Element, px des Bildes</translation>
  </message>
  <message>
   <source>{model}. Chosen: {why}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>{model}. Gewählt: {why}</translation>
  </message>
  <message numerus="yes">
   <source>{passing} of {n:,} annotated elements within {px:g} px</source>
   <extracomment>{passing} of {n:,} annotated element within {px:g} px / {passing} of {n:,} annotated elements within {px:g} px [procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>
    <numerusform>{passing} von {n:,} annotierten Element innerhalb {px:g} px</numerusform>
    <numerusform>{passing} von {n:,} annotierten Elementen innerhalb {px:g} px</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{counted}; {n} in sight not annotated yet</source>
   <extracomment>{counted}; {n} in sight not annotated yet / {counted}; {n} in sight not annotated yet [procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>
    <numerusform>{counted}; {n} sichtbares noch nicht annotiert</numerusform>
    <numerusform>{counted}; {n} sichtbare noch nicht annotiert</numerusform>
   </translation>
  </message>
  <message>
   <source>{title}: mean {mean} px, largest {largest} px</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>{title}: Mittel {mean} px, größtes {largest} px</translation>
  </message>
  <message>
   <source>Taken for a mistake: it had no say in the fit</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Für einen Irrtum gehalten: hatte bei der Anpassung nicht mitzureden</translation>
  </message>
  <message>
   <source>Elements in sight that are not annotated count against the JaC</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Sichtbare Elemente, die nicht annotiert sind, zählen gegen den JaC</translation>
  </message>
  <message>
   <source>Hardly determined: {limits}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Kaum bestimmt: {limits}</translation>
  </message>
  <message>
   <source>Mean distance of the points that had a say, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Mittlerer Abstand der Punkte, die mitreden durften, px des Bildes</translation>
  </message>
  <message>
   <source>Standard deviation, as the fit estimates it</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Standardabweichung, wie die Anpassung sie schätzt</translation>
  </message>
  <message>
   <source>Save as the frame's camera</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Als Kamera des Bildes speichern</translation>
  </message>
  <message>
   <source>✕ left out: {title}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>✕ ausgelassen: {title}</translation>
  </message>
  <message>
   <source>Pan</source>
   <comment>an angle</comment>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Schwenk</translation>
  </message>
  <message>
   <source>Tilt</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Neigung</translation>
  </message>
  <message>
   <source>Roll</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Rollen</translation>
  </message>
  <message>
   <source>Focal length</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Brennweite</translation>
  </message>
  <message>
   <source>Along (x)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Längs (x)</translation>
  </message>
  <message>
   <source>Across (y)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Quer (y)</translation>
  </message>
  <message>
   <source>Height (−z)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Höhe (−z)</translation>
  </message>
  <message>
   <source>Model</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Modell</translation>
  </message>
  <message>
   <source>Residuals by element</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Residuen je Element</translation>
  </message>
  <message>
   <source>No camera yet: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Noch keine Kamera: {why}.</translation>
  </message>
  <message>
   <source>Fitting the clicks…</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Klicks werden angepasst…</translation>
  </message>
  <message>
   <source>No fit.</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Keine Anpassung.</translation>
  </message>
  <message>
   <source>JaC at {tau:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/fit.py, procc_annotator/gui/panels/plots/pages.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>JaC bei {tau:.1f} px</translation>
  </message>
  <message>
   <source>&lt;b&gt;Hardly determined&lt;/b&gt;: {what}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>&lt;b&gt;Kaum bestimmt&lt;/b&gt;: {what}</translation>
  </message>
  <message>
   <source>JaC: {terms}; residuals: px of the picture, {width}x{height}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>JaC: {terms}; Residuen: px des Bildes, {width}x{height}</translation>
  </message>
  <message>
   <source>What is fitted. Automatically: the simplest model that the clicks support</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>Was angepasst wird. Automatisch: das einfachste Modell, das die Klicks hergeben</translation>
  </message>
  <message>
   <source>mean residual</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>mittleres Residuum</translation>
  </message>
  <message numerus="yes">
   <source>{n} open</source>
   <extracomment>{n} open / {n} open [procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>
    <numerusform>{n} offen</numerusform>
    <numerusform>{n} offen</numerusform>
   </translation>
  </message>
  <message>
   <source>all done</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>alle fertig</translation>
  </message>
  <message>
   <source>not annotated</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>nicht annotiert</translation>
  </message>
  <message>
   <source>⚠ unreadable</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>⚠ unlesbar</translation>
  </message>
  <message>
   <source>⚠ camera</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>⚠ Kamera</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} done</source>
   <extracomment>{n:,} done / {n:,} done [procc_annotator/gui/panels/frame_delegate.py, procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>
    <numerusform>{n:,} fertig</numerusform>
    <numerusform>{n:,} fertig</numerusform>
   </translation>
  </message>
  <message>
   <source>● not saved</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>● nicht gespeichert</translation>
  </message>
  <message>
   <source>the picture cannot be read</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>das Bild ist unlesbar</translation>
  </message>
  <message>
   <source>mean JaC {jac:.3f}</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>mittlerer JaC {jac:.3f}</translation>
  </message>
  <message>
   <source>folded</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>eingeklappt</translation>
  </message>
  <message>
   <source>unfolded</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>aufgeklappt</translation>
  </message>
  <message>
   <source>Filter frames</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>Bilder filtern</translation>
  </message>
  <message>
   <source>No frames.
Open a folder of pictures (jpg, png, bmp, webp), or drop one here.</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>Keine Bilder.
Öffnen Sie einen Ordner mit Bildern (jpg, png, bmp, webp), oder ziehen Sie einen hierher.</translation>
  </message>
  <message>
   <source>Nothing matches “{query}”.</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>Nichts passt zu „{query}“.</translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} folders</source>
   <extracomment>{frames} in {n:,} folder / {frames} in {n:,} folders [procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>
    <numerusform>{frames} in {n:,} Ordner</numerusform>
    <numerusform>{frames} in {n:,} Ordnern</numerusform>
   </translation>
  </message>
  <message>
   <source>No landmarks. A landmark is a place of this stadium that the field does not have: a seat, the corner of a board, a floodlight. Name one below, and click it in two calibrated views.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Keine Landmarken. Eine Landmarke ist ein Ort dieses Stadions, den das Feld nicht hat: ein Sitz, die Ecke einer Bande, ein Flutlicht. Benennen Sie unten eine, und klicken Sie sie in zwei kalibrierten Ansichten.</translation>
  </message>
  <message>
   <source>Find its place from the views it is clicked in; cameras are those of the active source, else fits to the clicks</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Ihren Ort aus den Ansichten bestimmen, in denen sie geklickt ist; die Kameras sind die der aktiven Quelle, sonst Anpassungen an die Klicks</translation>
  </message>
  <message>
   <source>Other views of this instant</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Andere Ansichten dieses Augenblicks</translation>
  </message>
  <message>
   <source>No other views</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Keine anderen Ansichten</translation>
  </message>
  <message>
   <source>Its place cannot be brought back with undo. Clicks on it stay in the annotations.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Ihr Ort lässt sich nicht rückgängig zurückholen. Klicks darauf bleiben in den Annotationen.</translation>
  </message>
  <message>
   <source>Landmark</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Landmarke</translation>
  </message>
  <message>
   <source>Views</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Ansichten</translation>
  </message>
  <message>
   <source>Triangulated from {frames}</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Trianguliert aus {frames}</translation>
  </message>
  <message>
   <source>Other views of this instant: go to one with a click</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Andere Ansichten dieses Augenblicks: mit einem Klick hingehen</translation>
  </message>
  <message>
   <source>{title} is clicked in no frame yet: click it in two calibrated views to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{title} ist noch in keinem Bild geklickt: klicken Sie sie in zwei kalibrierten Ansichten, damit sie trianguliert wird.</translation>
  </message>
  <message>
   <source>Clicked here, but no landmarks yet: {names}. Write a name next to Add to triangulate it.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Hier geklickt, aber noch keine Landmarken: {names}. Schreiben Sie einen Namen neben Hinzufügen, damit sie trianguliert werden.</translation>
  </message>
  <message>
   <source>Its place is not known yet</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Ihr Ort ist noch nicht bekannt</translation>
  </message>
  <message>
   <source>Surveyed</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Vermessen</translation>
  </message>
  <message>
   <source>New landmark</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Neue Landmarke</translation>
  </message>
  <message>
   <source>Add</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py, procc_annotator/gui/panels/review.py, procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Hinzufügen</translation>
  </message>
  <message>
   <source>What people call it</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Wie man sie nennt</translation>
  </message>
  <message>
   <source>x, y, z in metres, z down</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>x, y, z in Metern, z nach unten</translation>
  </message>
  <message>
   <source>Set</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Setzen</translation>
  </message>
  <message>
   <source>Triangulate</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Triangulieren</translation>
  </message>
  <message>
   <source>Standard deviation in the direction where it is largest</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Standardabweichung in der Richtung, in der sie am größten ist</translation>
  </message>
  <message>
   <source>{name} is being triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{name} wird trianguliert.</translation>
  </message>
  <message>
   <source>{why}. Delete the landmark and name it again to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{why}. Löschen Sie die Landmarke und benennen Sie sie neu, damit sie trianguliert wird.</translation>
  </message>
  <message>
   <source>Looking for the frames in which {title} is clicked…</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Suche nach Bildern, in denen {title} geklickt ist…</translation>
  </message>
  <message>
   <source>{title} is clicked in {frame} alone: click it in another calibrated view to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{title} ist nur in {frame} geklickt: klicken Sie sie in einer weiteren kalibrierten Ansicht, damit sie trianguliert wird.</translation>
  </message>
  <message>
   <source>Choose a landmark in the list to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Eine Landmarke in der Liste wählen, damit sie trianguliert wird.</translation>
  </message>
  <message>
   <source>Only a landmark that has a name can be triangulated: write one next to Add.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Nur eine Landmarke mit Namen lässt sich triangulieren: schreiben Sie einen neben Hinzufügen.</translation>
  </message>
  <message numerus="yes">
   <source>{names} and {n} more</source>
   <extracomment>{names} and {n} more / {names} and {n} more [procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>
    <numerusform>{names} und {n} weitere</numerusform>
    <numerusform>{names} und {n} weitere</numerusform>
   </translation>
  </message>
  <message>
   <source>Landmarks</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Landmarken</translation>
  </message>
  <message>
   <source>Have a new landmark, to be clicked (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Eine neue Landmarke anlegen, zum Klicken (Eingabe)</translation>
  </message>
  <message>
   <source>The place was measured: it stays as it is from now on (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Der Ort wurde vermessen: er bleibt ab jetzt, wie er ist (Eingabe)</translation>
  </message>
  <message>
   <source>Forget this landmark; clicks on it stay in the annotations</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Diese Landmarke vergessen; Klicks darauf bleiben in den Annotationen</translation>
  </message>
  <message>
   <source>Title</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Titel</translation>
  </message>
  <message>
   <source>Place</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Ort</translation>
  </message>
  <message>
   <source>Not clicked in any frame yet</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Noch in keinem Bild geklickt</translation>
  </message>
  <message>
   <source>Triangulating…</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Wird trianguliert…</translation>
  </message>
  <message>
   <source>a landmark needs a name: write one next to Add</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>eine Landmarke braucht einen Namen: schreiben Sie einen neben Hinzufügen</translation>
  </message>
  <message>
   <source>deleted the landmark {title}; clicks on it stay in the annotations</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>Landmarke {title} gelöscht; Klicks darauf bleiben in den Annotationen</translation>
  </message>
  <message>
   <source>the landmark {title}</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>die Landmarke {title}</translation>
  </message>
  <message>
   <source>Picture (*.png);;Vector graphics (*.svg)</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>Bild (*.png);;Vektorgrafik (*.svg)</translation>
  </message>
  <message>
   <source>the plotted numbers are on the clipboard</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>die Zahlen des Diagramms sind in der Zwischenablage</translation>
  </message>
  <message>
   <source>Save the plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>Diagramm speichern</translation>
  </message>
  <message>
   <source>wrote {path}, as far as scored</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>{path} geschrieben, soweit bewertet</translation>
  </message>
  <message>
   <source>wrote {path}</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>{path} geschrieben</translation>
  </message>
  <message>
   <source>the plot is on the clipboard as a picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>das Diagramm ist als Bild in der Zwischenablage</translation>
  </message>
  <message>
   <source>there is nothing plotted to take along</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>es gibt kein Diagramm zum Mitnehmen</translation>
  </message>
  <message>
   <source>{frames}, as far as scored</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>{frames}, soweit bewertet</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows committed frames only, and none of them is in this plot.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>Verborgen: der Blindmodus zeigt nur abgegebene Bilder, und keines davon ist in diesem Diagramm.</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows this plot once this frame is committed.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>Verborgen: im Blindmodus erscheint dieses Diagramm, sobald dieses Bild abgegeben ist.</translation>
  </message>
  <message>
   <source>Sources: {names}</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>Quellen: {names}</translation>
  </message>
  <message>
   <source>Shots are recognized by names, since {error}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>Einstellungen sind an den Namen erkannt, denn {error}.</translation>
  </message>
  <message>
   <source>JaC over tau</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>JaC über tau</translation>
  </message>
  <message>
   <source>JaC over the frames</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>JaC über die Bilder</translation>
  </message>
  <message>
   <source>No scores yet. They are computed in the background, frame by frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Noch keine Bewertungen. Sie werden Bild für Bild im Hintergrund berechnet.</translation>
  </message>
  <message>
   <source>Errors, as a histogram</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Fehler als Histogramm</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} points without a distance left out.</source>
   <extracomment>{n:,} point without a distance left out. / {n:,} points without a distance left out. [procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>
    <numerusform>{n:,} Punkt ohne Abstand ausgelassen.</numerusform>
    <numerusform>{n:,} Punkte ohne Abstand ausgelassen.</numerusform>
   </translation>
  </message>
  <message>
   <source>Residuals over the picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Residuen über dem Bild</translation>
  </message>
  <message>
   <source>tau (px)</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>tau (px)</translation>
  </message>
  <message>
   <source>frame</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Bild</translation>
  </message>
  <message>
   <source>{name} (frame {n})</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{name} (Bild {n})</translation>
  </message>
  <message>
   <source>No score of this frame: it is not annotated, or no shown source has its camera.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Keine Bewertung dieses Bildes: es ist nicht annotiert, oder keine gezeigte Quelle hat eine Kamera.</translation>
  </message>
  <message>
   <source>reprojection error (px)</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Reprojektionsfehler (px)</translation>
  </message>
  <message>
   <source>points</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Punkte</translation>
  </message>
  <message>
   <source>How many times longer than they are arrows are drawn</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Wie viel länger als in Wirklichkeit Pfeile gezeichnet sind</translation>
  </message>
  <message>
   <source>Arrows drawn longer</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Pfeile länger gezeichnet</translation>
  </message>
  <message>
   <source>The last bar holds all larger errors.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Der letzte Balken fasst alle größeren Fehler.</translation>
  </message>
  <message>
   <source>{px:g} px or more</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{px:g} px oder mehr</translation>
  </message>
  <message>
   <source>{name} {part:,} of {total:,}</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{name} {part:,} von {total:,}</translation>
  </message>
  <message>
   <source>No point of {element} in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Kein Punkt von {element} in diesem Bild.</translation>
  </message>
  <message>
   <source>No point of {element} so far.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Bisher kein Punkt von {element}.</translation>
  </message>
  <message>
   <source>No annotated point that a shown source projects in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Kein annotierter Punkt in diesem Bild, den eine gezeigte Quelle projiziert.</translation>
  </message>
  <message>
   <source>No annotated point that a shown source projects so far.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Bisher kein annotierter Punkt, den eine gezeigte Quelle projiziert.</translation>
  </message>
  <message>
   <source>automatic</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>automatisch</translation>
  </message>
  <message>
   <source>Arrows {factor} times as long as they are: from the click towards the projection.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Pfeile {factor}-mal so lang wie in Wirklichkeit: vom Klick zur Projektion.</translation>
  </message>
  <message>
   <source>Arrows {factor} times as long as they are: the median residual of each part of the picture with 5 points or more.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Pfeile {factor}-mal so lang wie in Wirklichkeit: das mediane Residuum jedes Bildteils mit 5 Punkten oder mehr.</translation>
  </message>
  <message>
   <source>Each curve is the mean of the frames that source has a camera for.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Jede Kurve ist das Mittel der Bilder, für die die Quelle eine Kamera hat.</translation>
  </message>
  <message>
   <source>Shaded: 95 % bands, {drawn}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Schattiert: 95-%-Bänder, {drawn}.</translation>
  </message>
  <message>
   <source>tau {px:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>tau {px:.1f} px</translation>
  </message>
  <message>
   <source>Too few points so far: five in a part of the picture make an arrow.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>Noch zu wenige Punkte: fünf in einem Bildteil ergeben einen Pfeil.</translation>
  </message>
  <message>
   <source>This frame</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Dieses Bild</translation>
  </message>
  <message>
   <source>Copy or save the plot and its numbers</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Das Diagramm und seine Zahlen kopieren oder speichern</translation>
  </message>
  <message>
   <source>Plot the points of one element only</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Nur die Punkte eines Elements auftragen</translation>
  </message>
  <message>
   <source>({n:,} of {total:,})</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>({n:,} von {total:,})</translation>
  </message>
  <message>
   <source>All elements</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Alle Elemente</translation>
  </message>
  <message>
   <source>Plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Diagramm</translation>
  </message>
  <message>
   <source>This plot could not be computed: {error}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Dieses Diagramm konnte nicht berechnet werden: {error}.</translation>
  </message>
  <message>
   <source>({n:,} committed)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>({n:,} abgegeben)</translation>
  </message>
  <message>
   <source>Copy or save the plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Das Diagramm kopieren oder speichern</translation>
  </message>
  <message>
   <source>Copy picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Bild kopieren</translation>
  </message>
  <message>
   <source>Copy numbers</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Zahlen kopieren</translation>
  </message>
  <message>
   <source>Save picture…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Bild speichern…</translation>
  </message>
  <message>
   <source>Save numbers…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Zahlen speichern…</translation>
  </message>
  <message>
   <source>Plot the frame on screen, or all frames scored so far</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Das gezeigte Bild auftragen, oder alle bisher bewerteten</translation>
  </message>
  <message>
   <source>Computing…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Wird berechnet…</translation>
  </message>
  <message>
   <source>(hidden)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>(verborgen)</translation>
  </message>
  <message>
   <source>(no score)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>(ohne Bewertung)</translation>
  </message>
  <message>
   <source>Save</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>Sichern</translation>
  </message>
  <message>
   <source>Committed in blind mode, and as it was then.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Im Blindmodus abgegeben, und noch wie damals.</translation>
  </message>
  <message>
   <source>Edited after the cameras were shown.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Bearbeitet, nachdem die Kameras gezeigt wurden.</translation>
  </message>
  <message>
   <source>{seconds} s</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{seconds} s</translation>
  </message>
  <message>
   <source>How the points of this frame came to be</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Wie die Punkte dieses Bildes entstanden</translation>
  </message>
  <message>
   <source>Add the comment to the thread (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Den Kommentar anfügen (Eingabe)</translation>
  </message>
  <message>
   <source>Committed in blind mode by {author}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Im Blindmodus abgegeben von {author}</translation>
  </message>
  <message>
   <source>{minutes}:{seconds:02d} min</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{minutes}:{seconds:02d} min</translation>
  </message>
  <message>
   <source>This frame is right (Ctrl+Shift+A)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Dieses Bild ist richtig (Strg+Umschalt+A)</translation>
  </message>
  <message>
   <source>Send it back (Ctrl+Shift+X)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Zurückgeben (Strg+Umschalt+X)</translation>
  </message>
  <message>
   <source>Reject</source>
   <extracomment>[procc_annotator/gui/panels/review.py, the action reject]</extracomment>
   <translation>Ablehnen</translation>
  </message>
  <message>
   <source>No comments on this frame.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Keine Kommentare zu diesem Bild.</translation>
  </message>
  <message>
   <source>Comment on this place</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Kommentar zu dieser Stelle</translation>
  </message>
  <message>
   <source>{frame} is {status}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{frame} ist {status}</translation>
  </message>
  <message>
   <source>{frame} is {status} again</source>
   <extracomment>[procc_annotator/gui/panels/review.py, procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} ist wieder {status}</translation>
  </message>
  <message>
   <source>Time worked on this frame; pauses over 30 s do not count</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>An diesem Bild gearbeitete Zeit; Pausen über 30 s zählen nicht</translation>
  </message>
  <message>
   <source>Comments</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Kommentare</translation>
  </message>
  <message>
   <source>Points: {kinds}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Punkte: {kinds}</translation>
  </message>
  <message>
   <source>Points: none</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Punkte: keine</translation>
  </message>
  <message numerus="yes">
   <source>to be confirmed (Shift+V): {n:,} elements</source>
   <extracomment>to be confirmed (Shift+V): {n:,} element / to be confirmed (Shift+V): {n:,} elements [procc_annotator/gui/panels/review.py]</extracomment>
   <translation>
    <numerusform>zu bestätigen (Umschalt+V): {n:,} Element</numerusform>
    <numerusform>zu bestätigen (Umschalt+V): {n:,} Elemente</numerusform>
   </translation>
  </message>
  <message>
   <source>Comment on this frame</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Kommentar zu diesem Bild</translation>
  </message>
  <message>
   <source>Ticked: settled</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>Angehakt: erledigt</translation>
  </message>
  <message>
   <source>somebody</source>
   <extracomment>[procc_annotator/gui/panels/review.py, procc_annotator/gui/state/editing/batch_edits.py, procc_annotator/gui/state/state.py]</extracomment>
   <translation>jemand</translation>
  </message>
  <message>
   <source>Choose an element to read why it counts as it does.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Ein Element wählen, um zu lesen, warum es so zählt.</translation>
  </message>
  <message>
   <source>the camera is the fit to these same clicks: this JaC is no score of a method</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>die Kamera ist die Anpassung an eben diese Klicks: dieser JaC bewertet keine Methode</translation>
  </message>
  <message>
   <source>Mirrored labels count here: the field turned by 180° fits at least as well.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Gespiegelte Klassen zählen hier: das um 180° gedrehte Feld passt mindestens so gut.</translation>
  </message>
  <message>
   <source>human noise {median:.2f} px, 95 % within {p95:.2f} px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>menschliches Rauschen {median:.2f} px, 95 % innerhalb {p95:.2f} px</translation>
  </message>
  <message>
   <source>human noise {median:.2f} px, 95 % within {p95:.2f} px – more than tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>menschliches Rauschen {median:.2f} px, 95 % innerhalb {p95:.2f} px – mehr als tau</translation>
  </message>
  <message>
   <source>Point</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Punkt</translation>
  </message>
  <message>
   <source>Worst</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Größter</translation>
  </message>
  <message>
   <source>Passes at</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Besteht ab</translation>
  </message>
  <message>
   <source>Click a row to see the point that decides</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Eine Zeile anklicken, um den entscheidenden Punkt zu sehen</translation>
  </message>
  <message>
   <source>How the element counts at tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Wie das Element bei tau zählt</translation>
  </message>
  <message>
   <source>The point that decides, counted from 1</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Der entscheidende Punkt, gezählt ab 1</translation>
  </message>
  <message>
   <source>Largest distance of its points to the projection, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Größter Abstand seiner Punkte zur Projektion, px</translation>
  </message>
  <message>
   <source>The smallest tau of the slider at which it passes, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Das kleinste tau des Schiebers, bei dem es besteht, px</translation>
  </message>
  <message>
   <source>Camera wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Kamera falsch</translation>
  </message>
  <message>
   <source>Labels wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Annotation falsch</translation>
  </message>
  <message>
   <source>The active camera is wrong in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Die aktive Kamera ist in diesem Bild falsch</translation>
  </message>
  <message>
   <source>The clicks are wrong in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Die Klicks sind in diesem Bild falsch</translation>
  </message>
  <message>
   <source>Camera and clicks are right in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Kamera und Klicks sind in diesem Bild richtig</translation>
  </message>
  <message>
   <source>What causes the score of this frame; saved with the dataset</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Woran die Bewertung dieses Bildes liegt; wird beim Datensatz aufbewahrt</translation>
  </message>
  <message>
   <source>Precision</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Precision</translation>
  </message>
  <message>
   <source>Recall</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Recall</translation>
  </message>
  <message>
   <source>Mean error</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Mittlerer Fehler</translation>
  </message>
  <message>
   <source>Mean reprojection error of all points, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Mittlerer Reprojektionsfehler aller Punkte, px</translation>
  </message>
  <message>
   <source>Median reprojection error, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Median des Reprojektionsfehlers, px</translation>
  </message>
  <message>
   <source>Max</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Max.</translation>
  </message>
  <message>
   <source>Largest reprojection error, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Größter Reprojektionsfehler, px</translation>
  </message>
  <message>
   <source>{name} has no camera for this frame.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>{name} hat keine Kamera für dieses Bild.</translation>
  </message>
  <message>
   <source>points: {kinds}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Punkte: {kinds}</translation>
  </message>
  <message>
   <source>{verdict}; once more takes it back ({key})</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>{verdict}; noch einmal nimmt es zurück ({key})</translation>
  </message>
  <message>
   <source>Verdict: {verdict}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Urteil: {verdict}</translation>
  </message>
  <message>
   <source>Scores by element</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Bewertung je Element</translation>
  </message>
  <message>
   <source>Copy this explanation</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Diese Erklärung kopieren</translation>
  </message>
  <message>
   <source>Copy all explanations</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Alle Erklärungen kopieren</translation>
  </message>
  <message>
   <source>JaC –: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>JaC –: {why}.</translation>
  </message>
  <message>
   <source>This frame's camera cannot be used:
{error}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Die Kamera dieses Bildes ist nicht zu gebrauchen:
{error}</translation>
  </message>
  <message>
   <source>No fit to judge: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Keine Anpassung zu beurteilen: {why}.</translation>
  </message>
  <message>
   <source>Counts as {class_name}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Zählt als {class_name}</translation>
  </message>
  <message>
   <source>Verdict</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Urteil</translation>
  </message>
  <message>
   <source>Elements whose points all are closer than tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Elemente, deren Punkte alle näher als tau sind</translation>
  </message>
  <message>
   <source>Elements too far, or projected and not annotated</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Elemente zu weit weg, oder projiziert und nicht annotiert</translation>
  </message>
  <message>
   <source>Annotated elements that the camera does not project</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>Annotierte Elemente, die die Kamera nicht projiziert</translation>
  </message>
  <message>
   <source>anchor</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>Anker</translation>
  </message>
  <message>
   <source>followed</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>verfolgt</translation>
  </message>
  <message>
   <source>bridged</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>überbrückt</translation>
  </message>
  <message>
   <source>lost</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>verloren</translation>
  </message>
  <message>
   <source>frame {number} of {first}–{last}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>Bild {number} von {first}–{last}</translation>
  </message>
  <message>
   <source>{state}, {share:.0%} of the lines on paint</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>{state}, {share:.0%} der Linien auf Farbe</translation>
  </message>
  <message>
   <source>names count by {step}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>Namen zählen in Schritten von {step}</translation>
  </message>
  <message>
   <source>its camera was dragged</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>ihre Kamera wurde gezogen</translation>
  </message>
  <message>
   <source>blind: its camera is hidden</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>blind: die Kamera ist verborgen</translation>
  </message>
  <message>
   <source>{found}, {far:.1f} px from it</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>{found}, {far:.1f} px davon entfernt</translation>
  </message>
  <message>
   <source>doubtful: {why}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>zweifelhaft: {why}</translation>
  </message>
  <message>
   <source>Frames of the shot</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>Bilder der Einstellung</translation>
  </message>
  <message>
   <source>The arrows go from frame to frame, with Shift they mark a stretch, Esc forgets it</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>Die Pfeiltasten gehen von Bild zu Bild, mit Umschalt markieren sie einen Abschnitt, Esc vergisst ihn</translation>
  </message>
  <message>
   <source>not {number:g}: {least:g} to {most:g}{unit}</source>
   <extracomment>[procc_annotator/gui/panels/widgets.py]</extracomment>
   <translation>nicht {number:g}: {least:g} bis {most:g}{unit}</translation>
  </message>
  <message>
   <source>Fit and ghosts</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting fit_model, the setting ghost_support]</extracomment>
   <translation>Anpassung und Geister</translation>
  </message>
  <message>
   <source>Annotating</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting author, the setting auto_advance]</extracomment>
   <translation>Annotieren</translation>
  </message>
  <message>
   <source>blind: the camera is hidden until this frame is committed (Ctrl+Enter)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>blind: die Kamera ist verborgen, bis dieses Bild abgegeben ist (Strg+Eingabe)</translation>
  </message>
  <message>
   <source>load cameras first: there is nothing to score</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>laden Sie zuerst Kameras: es gibt nichts zu bewerten</translation>
  </message>
  <message>
   <source>open a folder of pictures first</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>öffnen Sie zuerst einen Ordner mit Bildern</translation>
  </message>
  <message>
   <source>choose the camera to judge first (C)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>wählen Sie zuerst die Kamera, die beurteilt wird (C)</translation>
  </message>
  <message>
   <source>the live fit is off (Ctrl+T)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>die laufende Anpassung ist aus (Strg+T)</translation>
  </message>
  <message>
   <source>{text}.</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>{text}.</translation>
  </message>
  <message>
   <source>unexpected error ({what})</source>
   <extracomment>[procc_annotator/gui/state/background.py]</extracomment>
   <translation>unerwarteter Fehler ({what})</translation>
  </message>
  <message>
   <source>expected files like camera_00037.json, 00037.npy or 00037.homographyMatrix</source>
   <extracomment>[procc_annotator/gui/state/camera_sources.py]</extracomment>
   <translation>erwartet sind Dateien wie camera_00037.json, 00037.npy oder 00037.homographyMatrix</translation>
  </message>
  <message>
   <source>load one of its folders: {names}</source>
   <extracomment>[procc_annotator/gui/state/camera_sources.py]</extracomment>
   <translation>laden Sie einen ihrer Ordner: {names}</translation>
  </message>
  <message>
   <source>it holds the same already</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>es enthält bereits dasselbe</translation>
  </message>
  <message>
   <source>it is annotated already</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>es ist schon annotiert</translation>
  </message>
  <message>
   <source>{who} is editing it</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>{who} bearbeitet es</translation>
  </message>
  <message>
   <source>it cannot be edited</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>es lässt sich nicht bearbeiten</translation>
  </message>
  <message>
   <source>blind: nothing is annotated here; Ctrl+Enter again shows the cameras, and what is clicked after that is no blind work</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>blind: hier ist nichts annotiert; noch einmal Strg+Eingabe zeigt die Kameras, und was danach geklickt wird, ist keine blinde Arbeit</translation>
  </message>
  <message>
   <source>{frame} is done</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} ist fertig</translation>
  </message>
  <message>
   <source>nothing to undo on this frame</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>in diesem Bild ist nichts rückgängig zu machen</translation>
  </message>
  <message>
   <source>undo once more takes that away</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>noch einmal Rückgängig nimmt das weg</translation>
  </message>
  <message>
   <source>{frame} was changed elsewhere and read again: {so}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} wurde anderswo geändert und neu gelesen: {so}</translation>
  </message>
  <message>
   <source>unconfirmed elements do not count: {count}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>unbestätigte Elemente zählen nicht: {count}</translation>
  </message>
  <message>
   <source>undone: {step}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>rückgängig: {step}</translation>
  </message>
  <message>
   <source>redone: {step}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>wiederholt: {step}</translation>
  </message>
  <message>
   <source>{frame} was changed elsewhere: read again</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} wurde anderswo geändert: neu gelesen</translation>
  </message>
  <message>
   <source>nothing is undone</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>nichts wird rückgängig gemacht</translation>
  </message>
  <message>
   <source>nothing is redone</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>nichts wird wiederholt</translation>
  </message>
  <message>
   <source>nothing to redo on this frame</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>in diesem Bild ist nichts zu wiederholen</translation>
  </message>
  <message>
   <source>cameras of {name} changed: {why}</source>
   <extracomment>[procc_annotator/gui/state/editing/outside_changes.py]</extracomment>
   <translation>Kameras von {name} geändert: {why}</translation>
  </message>
  <message>
   <source>cameras of {name} changed on disk: read again</source>
   <extracomment>[procc_annotator/gui/state/editing/outside_changes.py]</extracomment>
   <translation>Kameras von {name} auf der Platte geändert: neu gelesen</translation>
  </message>
  <message>
   <source>not saved: {why}</source>
   <extracomment>[procc_annotator/gui/state/editing/saving.py]</extracomment>
   <translation>nicht gespeichert: {why}</translation>
  </message>
  <message>
   <source>the dataset's landmarks stay as they were: {why}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>die Landmarken des Datensatzes bleiben, wie sie waren: {why}</translation>
  </message>
  <message>
   <source>{title} is at {place} m, ± {deviations}, from {views} views</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>{title} liegt bei {place} m, ± {deviations}, aus {views} Ansichten</translation>
  </message>
  <message>
   <source>{title} was deleted meanwhile: its place was not kept</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>{title} wurde inzwischen gelöscht: der Ort wurde nicht behalten</translation>
  </message>
  <message>
   <source>left out: {names}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>ausgelassen: {names}</translation>
  </message>
  <message>
   <source>the dataset's landmarks are not used: {why}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>die Landmarken des Datensatzes werden nicht verwendet: {why}</translation>
  </message>
  <message>
   <source>the dataset's landmarks can be used again</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>die Landmarken des Datensatzes sind wieder verwendbar</translation>
  </message>
  <message>
   <source>{names} share only where the elements are shown, no camera: there is no ground to compare.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{names} sagen nur, wo die Elemente liegen, keine Kamera: es gibt keinen Boden zum Vergleichen.</translation>
  </message>
  <message>
   <source>{names}: no camera for this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{names}: keine Kamera für dieses Bild.</translation>
  </message>
  <message>
   <source>{name} shares only where the elements are shown, no camera: there is no ground to compare.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{name} sagt nur, wo die Elemente liegen, keine Kamera: es gibt keinen Boden zum Vergleichen.</translation>
  </message>
  <message>
   <source>{a} and {b}</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{a} und {b}</translation>
  </message>
  <message>
   <source>The two see no part of the field in common in this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Beide sehen in diesem Bild keinen gemeinsamen Teil des Feldes.</translation>
  </message>
  <message>
   <source>Both cameras are the same in this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Beide Kameras sind in diesem Bild gleich.</translation>
  </message>
  <message>
   <source>No source is judged: choose one first.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Keine Quelle wird beurteilt: wählen Sie zuerst eine.</translation>
  </message>
  <message>
   <source>Two sources of cameras are needed: load another one.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Zwei Kameraquellen sind nötig: laden Sie eine weitere.</translation>
  </message>
  <message>
   <source>The fitted camera sees no part of the field.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Die angepasste Kamera sieht keinen Teil des Feldes.</translation>
  </message>
  <message>
   <source>There is no fit of this frame, so no uncertainty map.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Zu diesem Bild gibt es keine Anpassung, daher keine Karte der Unsicherheit.</translation>
  </message>
  <message>
   <source>No camera yet, so no uncertainty map: {why}.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>Noch keine Kamera, daher keine Karte der Unsicherheit: {why}.</translation>
  </message>
  <message>
   <source>the painted width cannot be drawn: {why}</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>die Linienbreite lässt sich nicht zeichnen: {why}</translation>
  </message>
  <message>
   <source>{file} says what the field of this dataset is: to choose another one, move that file away and open the dataset again</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>{file} sagt, was das Feld dieses Datensatzes ist: um ein anderes zu wählen, legen Sie die Datei weg und öffnen Sie den Datensatz neu</translation>
  </message>
  <message>
   <source>field: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>Feld: {field}</translation>
  </message>
  <message>
   <source>this dataset's field from now on: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>das Feld dieses Datensatzes ab jetzt: {field}</translation>
  </message>
  <message>
   <source>this dataset's field from now on, {reach}: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>das Feld dieses Datensatzes ab jetzt, {reach}: {field}</translation>
  </message>
  <message>
   <source>no other field knows the classes here better</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>kein anderes Feld kennt die Klassen hier besser</translation>
  </message>
  <message>
   <source>{folder} cannot be written: what is annotated here has to be saved elsewhere (File &gt; Save copies to…)</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>{folder} ist nicht beschreibbar: Annotationen müssen anderswo gespeichert werden (Datei &gt; Kopien sichern in…)</translation>
  </message>
  <message>
   <source>not everything is saved yet: the other dataset was not opened</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>noch ist nicht alles gespeichert: der andere Datensatz wurde nicht geöffnet</translation>
  </message>
  <message>
   <source>not everything is saved yet: the video was not opened</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>noch ist nicht alles gespeichert: das Video wurde nicht geöffnet</translation>
  </message>
  <message>
   <source>nothing is open</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>nichts ist geöffnet</translation>
  </message>
  <message>
   <source>unfinished elements were kept: {titles}</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>unfertige Elemente sind aufgehoben: {titles}</translation>
  </message>
  <message>
   <source>the field of this dataset: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>das Feld dieses Datensatzes: {field}</translation>
  </message>
  <message>
   <source>the filter shows no further frame this way</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>der Filter zeigt in dieser Richtung kein weiteres Bild</translation>
  </message>
  <message>
   <source>you rejected it (Ctrl+Z takes that back)</source>
   <extracomment>[procc_annotator/gui/state/prediction/camera_choice.py]</extracomment>
   <translation>von Ihnen abgelehnt (Strg+Z nimmt das zurück)</translation>
  </message>
  <message>
   <source>draw 3 elements, two of which meet, such as {names}</source>
   <extracomment>[procc_annotator/gui/state/prediction/ghosts.py]</extracomment>
   <translation>zeichnen Sie 3 Elemente, von denen zwei sich treffen, etwa {names}</translation>
  </message>
  <message>
   <source>{title}: its line could not be looked for: {why}</source>
   <extracomment>[procc_annotator/gui/state/prediction/ghosts.py]</extracomment>
   <translation>{title}: seine Linie konnte nicht gesucht werden: {why}</translation>
  </message>
  <message>
   <source>chosen automatically</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>automatisch gewählt</translation>
  </message>
  <message>
   <source>H: homography of the ground</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>H: Homographie des Bodens</translation>
  </message>
  <message>
   <source>P: pinhole</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>P: Lochkamera</translation>
  </message>
  <message>
   <source>R: pinhole, lens distortion</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R: Lochkamera, Linsenverzeichnung</translation>
  </message>
  <message>
   <source>R+: R, aspect ratio, principal point</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R+: R, Seitenverhältnis, Bildhauptpunkt</translation>
  </message>
  <message>
   <source>R2: R+, second radial coefficient</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R2: R+, zweiter radialer Koeffizient</translation>
  </message>
  <message>
   <source>F: fisheye</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>F: Fischauge</translation>
  </message>
  <message>
   <source>the fit failed: {why}</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py]</extracomment>
   <translation>die Anpassung misslang: {why}</translation>
  </message>
  <message>
   <source>{who} unlocked this dataset from blind mode on {day}</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{who} hat am {day} den Blindmodus dieses Datensatzes aufgehoben</translation>
  </message>
  <message>
   <source>{frame} was {status} and is in progress again</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} war {status} und ist wieder in Arbeit</translation>
  </message>
  <message>
   <source>for you alone: the dataset's folder cannot be written</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>nur für Sie: der Ordner des Datensatzes ist nicht beschreibbar</translation>
  </message>
  <message>
   <source>{reason}: there is no live fit in it</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{reason}: darin gibt es keine laufende Anpassung</translation>
  </message>
  <message>
   <source>This dataset is locked to blind mode</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>Dieser Datensatz ist auf Blindmodus festgelegt</translation>
  </message>
  <message>
   <source>Somebody</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>Jemand</translation>
  </message>
  <message>
   <source>{who} locked this dataset to blind mode on {day}</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{who} hat diesen Datensatz am {day} auf Blindmodus festgelegt</translation>
  </message>
  <message>
   <source>{frame} was {status} and is in progress again: edited after the cameras were shown, it is no blind work any more</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} war {status} und ist wieder in Arbeit: nach dem Zeigen der Kameras bearbeitet, ist es keine blinde Arbeit mehr</translation>
  </message>
  <message>
   <source>in this window only: nothing can be written</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>nur in diesem Fenster: nichts lässt sich schreiben</translation>
  </message>
  <message>
   <source>this dataset is not locked to blind mode any more</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>dieser Datensatz ist nicht mehr auf Blindmodus festgelegt</translation>
  </message>
  <message>
   <source>{reason}: menu Frame unlocks it, which is recorded</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{reason}: das Menü Bild hebt es auf, was vermerkt wird</translation>
  </message>
  <message>
   <source>this dataset is locked to blind mode</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>dieser Datensatz ist auf Blindmodus festgelegt</translation>
  </message>
  <message>
   <source>{path}: no camera has the name of a frame (cameras are named like {camera!r}, frames like {frame!r})</source>
   <extracomment>[procc_annotator/gui/state/scoring/commands.py]</extracomment>
   <translation>{path}: keine Kamera heißt wie ein Bild (Kameras heißen wie {camera!r}, Bilder wie {frame!r})</translation>
  </message>
  <message>
   <source>{path}: no cameras in it ({what_to_do})</source>
   <extracomment>[procc_annotator/gui/state/scoring/commands.py]</extracomment>
   <translation>{path}: keine Kameras darin ({what_to_do})</translation>
  </message>
  <message numerus="yes">
   <source>no class of this field: {n} labels ({names})</source>
   <extracomment>no class of this field: {n} label ({names}) / no class of this field: {n} labels ({names}) [procc_annotator/gui/state/second.py]</extracomment>
   <translation>
    <numerusform>keine Klasse dieses Feldes: {n} Label ({names})</numerusform>
    <numerusform>keine Klassen dieses Feldes: {n} Labels ({names})</numerusform>
   </translation>
  </message>
  <message>
   <source>{path}: holds no annotation (*.json)</source>
   <extracomment>[procc_annotator/gui/state/second.py]</extracomment>
   <translation>{path}: enthält keine Annotation (*.json)</translation>
  </message>
  <message>
   <source>second annotator: {why}</source>
   <extracomment>[procc_annotator/gui/state/second.py]</extracomment>
   <translation>zweiter Annotator: {why}</translation>
  </message>
  <message>
   <source>{who} is editing it; it opens by itself once they leave it</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>{who} bearbeitet es; es öffnet sich von selbst, sobald es verlassen wird</translation>
  </message>
  <message>
   <source>nothing annotated yet</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>noch nichts annotiert</translation>
  </message>
  <message>
   <source>{who} on {machine}</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>{who} an {machine}</translation>
  </message>
  <message>
   <source>annotation cannot be read</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>Annotation ist unlesbar</translation>
  </message>
  <message>
   <source>Enter runs it · ↑ ↓ choose · Esc closes</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Eingabe führt aus · ↑ ↓ wählt · Esc schließt</translation>
  </message>
  <message>
   <source>Panel</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Bereich</translation>
  </message>
  <message>
   <source>Setting</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Einstellung</translation>
  </message>
  <message>
   <source>Open</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Öffnen</translation>
  </message>
  <message>
   <source>An action, element, frame, camera source, folder, number</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Aktion, Element, Bild, Kameraquelle, Ordner, Zahl</translation>
  </message>
  <message>
   <source>Find anything</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Alles finden</translation>
  </message>
  <message>
   <source>Nothing is called “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Nichts heißt „{text}“.</translation>
  </message>
  <message>
   <source>Threshold {px:g} px</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Schwelle {px:g} px</translation>
  </message>
  <message>
   <source>Frame {number} of {count}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Bild {number} von {count}</translation>
  </message>
  <message>
   <source>Go to this frame</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Zu diesem Bild gehen</translation>
  </message>
  <message>
   <source>Judge elements by this tau</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Elemente mit diesem tau beurteilen</translation>
  </message>
  <message>
   <source>What fits</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Was passt</translation>
  </message>
  <message>
   <source>Judge {source}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Beurteilen: {source}</translation>
  </message>
  <message>
   <source>Judge with this source</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Mit dieser Quelle beurteilen</translation>
  </message>
  <message>
   <source>Live fit: model {model}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Laufende Anpassung: Modell {model}</translation>
  </message>
  <message>
   <source>Panel {title}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Bereich {title}</translation>
  </message>
  <message>
   <source>Open this panel and bring it to the front</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Diesen Bereich öffnen und nach vorn holen</translation>
  </message>
  <message>
   <source>on</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>an</translation>
  </message>
  <message>
   <source>off</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>aus</translation>
  </message>
  <message>
   <source>User guide</source>
   <extracomment>[procc_annotator/gui/window/commands.py, the action guide]</extracomment>
   <translation>Handbuch</translation>
  </message>
  <message>
   <source>Find words in this page</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>Wörter auf dieser Seite suchen</translation>
  </message>
  <message>
   <source>The user guide is in English.</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>Das Handbuch ist auf Englisch.</translation>
  </message>
  <message>
   <source>this installation came without its user guide</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>diese Installation kam ohne ihr Handbuch</translation>
  </message>
  <message>
   <source>About ProCC Annotator</source>
   <extracomment>[procc_annotator/gui/window/commands.py, the action about]</extracomment>
   <translation>Über ProCC Annotator</translation>
  </message>
  <message>
   <source>ProCC Annotator {version}
Annotate and audit sports-camera calibrations.</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>ProCC Annotator {version}
Kalibrierungen von Sportkameras mit dem ProCC-Protokoll annotieren und prüfen.</translation>
  </message>
  <message>
   <source>Headings</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>Überschriften</translation>
  </message>
  <message>
   <source>no cameras are loaded (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>keine Kameras geladen (Strg+L)</translation>
  </message>
  <message>
   <source>load a second set of cameras to see side by side (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>laden Sie einen zweiten Kamerasatz, um beide nebeneinander zu sehen (Strg+L)</translation>
  </message>
  <message>
   <source>load a second set of cameras to compare (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>laden Sie einen zweiten Kamerasatz zum Vergleichen (Strg+L)</translation>
  </message>
  <message>
   <source>Brightness</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Helligkeit</translation>
  </message>
  <message>
   <source>Contrast</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Kontrast</translation>
  </message>
  <message>
   <source>Gamma</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Gamma</translation>
  </message>
  <message>
   <source>Bring out worn and shaded lines</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Abgenutzte und beschattete Linien hervorholen</translation>
  </message>
  <message>
   <source>Only what you see changes, never the file</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Nur was Sie sehen, ändert sich, nie die Datei</translation>
  </message>
  <message>
   <source>Reset</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Zurücksetzen</translation>
  </message>
  <message>
   <source>Shift all values</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Alle Werte verschieben</translation>
  </message>
  <message>
   <source>Stretch values about middle grey</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Werte um das mittlere Grau spreizen</translation>
  </message>
  <message>
   <source>To the right, dark parts become lighter</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Nach rechts werden dunkle Teile heller</translation>
  </message>
  <message>
   <source>Line enhance</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Linien verstärken</translation>
  </message>
  <message>
   <source>Show the picture as it is</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>Das Bild zeigen, wie es ist</translation>
  </message>
  <message>
   <source>Keys of your own</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Eigene Tasten</translation>
  </message>
  <message>
   <source>Keys (*.json)</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Tasten (*.json)</translation>
  </message>
  <message>
   <source>{menu}: {action}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{menu}: {action}</translation>
  </message>
  <message>
   <source>Search: a word, or a key. A click does what a row says.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Suche: ein Wort oder eine Taste. Ein Klick tut, was die Zeile sagt.</translation>
  </message>
  <message>
   <source>In the picture</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Im Bild</translation>
  </message>
  <message>
   <source>No key, action or element has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Keine Taste, keine Aktion und kein Element hat „{text}“.</translation>
  </message>
  <message>
   <source>Search: a word, or a key</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Suche: ein Wort oder eine Taste</translation>
  </message>
  <message>
   <source>Choose a row, then press its keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Eine Zeile wählen, dann ihre Tasten drücken</translation>
  </message>
  <message>
   <source>{one} or {other}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>{one} oder {other}</translation>
  </message>
  <message>
   <source>Keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py, the action keys]</extracomment>
   <translation>Tasten</translation>
  </message>
  <message>
   <source>Change keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Tasten ändern</translation>
  </message>
  <message>
   <source>Only these</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Nur diese</translation>
  </message>
  <message>
   <source>No keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Keine Tasten</translation>
  </message>
  <message>
   <source>Default keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Standardtasten</translation>
  </message>
  <message>
   <source>Import…</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Importieren…</translation>
  </message>
  <message>
   <source>⚠ Keys that call two actions call neither: give one of them other keys.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>⚠ Tasten, die zwei Aktionen rufen, rufen keine: geben Sie einer davon andere Tasten.</translation>
  </message>
  <message>
   <source>Export keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Tasten exportieren</translation>
  </message>
  <message>
   <source>Import keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Tasten importieren</translation>
  </message>
  <message>
   <source>New keys: press them here</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Neue Tasten: hier drücken</translation>
  </message>
  <message>
   <source>Search the keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Tasten durchsuchen</translation>
  </message>
  <message>
   <source>Search</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Suche</translation>
  </message>
  <message>
   <source>All keys at once</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Alle Tasten auf einmal</translation>
  </message>
  <message>
   <source>{file}: {error}; the keys stay as they are</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>{file}: {error}; die Tasten bleiben, wie sie sind</translation>
  </message>
  <message>
   <source>Action or element</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>Aktion oder Element</translation>
  </message>
  <message>
   <source>⚠ also: {what}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>⚠ auch: {what}</translation>
  </message>
  <message>
   <source>Change class to (swaps with an annotated one)</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Klasse ändern in (tauscht mit einer annotierten)</translation>
  </message>
  <message>
   <source>Drawing {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{title} wird gezeichnet</translation>
  </message>
  <message>
   <source>Split here: the rest becomes</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Hier teilen: der Rest wird</translation>
  </message>
  <message>
   <source>Ghost of {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Geist von {title}</translation>
  </message>
  <message>
   <source>Accept</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Annehmen</translation>
  </message>
  <message>
   <source>Look closely</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Genau ansehen</translation>
  </message>
  <message>
   <source>Not visible here</source>
   <extracomment>[procc_annotator/gui/window/menus.py, the action not_visible]</extracomment>
   <translation>Hier nicht sichtbar</translation>
  </message>
  <message>
   <source>{action}: {step}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{action}: {step}</translation>
  </message>
  <message>
   <source>Point {number} of {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Punkt {number} von {title}</translation>
  </message>
  <message>
   <source>Not visible here: take back</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Hier nicht sichtbar: zurücknehmen</translation>
  </message>
  <message>
   <source>Merge into</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>Vereinen mit</translation>
  </message>
  <message>
   <source>{title}, unconfirmed</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{title}, unbestätigt</translation>
  </message>
  <message>
   <source>ground ±{metres:.2f} m</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Boden ±{metres:.2f} m</translation>
  </message>
  <message>
   <source>unexpected error ({what}); saving goes on, the details are in {path}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>unerwarteter Fehler ({what}); es wird weiter gespeichert, Einzelheiten stehen in {path}</translation>
  </message>
  <message>
   <source>Cursor in picture pixels; the centre of the top left pixel is 0 0</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Mauszeiger in Bildpixeln; die Mitte des Pixels oben links ist 0 0</translation>
  </message>
  <message>
   <source>Cursor on the ground of the field, in metres from its centre</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Mauszeiger auf dem Boden des Feldes, in Metern von seiner Mitte</translation>
  </message>
  <message>
   <source>How far apart the active and the compared camera see the cursor:
on the ground, and in pixels of the evaluation size</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Wie weit auseinander die aktive und die verglichene Kamera den Mauszeiger sehen:
am Boden, und in Pixeln der Auswertungsgröße</translation>
  </message>
  <message>
   <source>How surely the fitted camera knows the ground point at the cursor: standard
deviation in the worst direction, whatever the cursor itself is off by</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Wie sicher die angepasste Kamera den Bodenpunkt am Mauszeiger kennt: Standard-
abweichung in der schlechtesten Richtung, was immer der Mauszeiger selbst danebenliegt</translation>
  </message>
  <message>
   <source>scoring {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>bewertet {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Camera &gt; Stop scoring the set ends it</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Kamera &gt; Bewertung des Satzes anhalten beendet es</translation>
  </message>
  <message>
   <source>comparing {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>vergleicht {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>ghosts {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Geister {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Esc ends it</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Esc beendet es</translation>
  </message>
  <message>
   <source>This frame is not editable. {problem}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Dieses Bild lässt sich nicht bearbeiten. {problem}</translation>
  </message>
  <message>
   <source>the details are copied; they are in {path}, too</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>die Einzelheiten sind kopiert; sie stehen auch in {path}</translation>
  </message>
  <message>
   <source>there was no unexpected error; they are logged in {path}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>es gab keinen unerwarteten Fehler; protokolliert werden sie in {path}</translation>
  </message>
  <message>
   <source>not editable: the bar over the picture says why</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>nicht zu bearbeiten: die Leiste über dem Bild sagt, warum</translation>
  </message>
  <message>
   <source>Picture
Brightness, contrast, gamma, line enhance: only what you see changes</source>
   <extracomment>[procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>Bild
Helligkeit, Kontrast, Gamma, Linien verstärken: nur was Sie sehen, ändert sich</translation>
  </message>
  <message>
   <source>Rail</source>
   <extracomment>[procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>Werkzeugleiste</translation>
  </message>
  <message>
   <source>Jaccard index of this frame at tau</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Jaccard-Index dieses Bildes bei tau</translation>
  </message>
  <message>
   <source>Threshold tau: an element passes when all its points are nearer (+ and -)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Schwelle tau: ein Element besteht, wenn alle seine Punkte näher liegen (+ und -)</translation>
  </message>
  <message>
   <source>The camera set that is judged (C switches)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Der Kamerasatz, der beurteilt wird (C wechselt)</translation>
  </message>
  <message>
   <source>Status of this frame (panel Review)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Status dieses Bildes (Bereich Durchsicht)</translation>
  </message>
  <message>
   <source>What the score is computed with: {terms}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Womit die Bewertung berechnet ist: {terms}</translation>
  </message>
  <message>
   <source>saved {time}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>gespeichert {time}</translation>
  </message>
  <message numerus="yes">
   <source>NOT SAVED: {n} frames</source>
   <extracomment>NOT SAVED: {n} frame / NOT SAVED: {n} frames [procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>
    <numerusform>NICHT GESPEICHERT: {n} Bild</numerusform>
    <numerusform>NICHT GESPEICHERT: {n} Bilder</numerusform>
   </translation>
  </message>
  <message>
   <source>Field: {field}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Feld: {field}</translation>
  </message>
  <message>
   <source>Click to choose another one</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Klicken, um ein anderes zu wählen</translation>
  </message>
  <message>
   <source>saving...</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>speichert...</translation>
  </message>
  <message>
   <source>Threshold tau</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Schwelle tau</translation>
  </message>
  <message>
   <source>JaC {jac:.3f} of the fit</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>JaC {jac:.3f} (fit)</translation>
  </message>
  <message>
   <source>blind: commit to see JaC</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>blind: erst abgeben</translation>
  </message>
  <message>
   <source>{n} of {total}</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>{n} von {total}</translation>
  </message>
  <message>
   <source>The camera is found without a click; dashed: what it expects. Shift+Enter accepts that</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Die Kamera wird ohne Klick gefunden; gestrichelt: was sie erwartet. Umschalt+Eingabe nimmt es an</translation>
  </message>
  <message>
   <source>W switches to editing: drag a point off its line</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>W wechselt zum Bearbeiten: ziehen Sie einen Punkt von seiner Linie weg</translation>
  </message>
  <message>
   <source>The tab Check lists possible mistakes: open it. F12 applies the first remedy</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Der Reiter „Befunde“ zeigt mögliche Fehler: öffnen Sie ihn. F12 führt die erste Abhilfe aus</translation>
  </message>
  <message>
   <source>Ctrl+Enter: this frame is done</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Strg+Eingabe: dieses Bild ist fertig</translation>
  </message>
  <message>
   <source>Ctrl+Shift+D: a frame without annotation. W, and draw a line: click its ends, press Enter, choose its name</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Strg+Umschalt+D: ein Bild ohne Annotation. W, Linie zeichnen: Enden anklicken, Eingabe, Namen wählen</translation>
  </message>
  <message>
   <source>Judge, at the top right (Shift+F2), then C: the fitted camera, judged by your annotation</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>„Beurteilen“ oben rechts (Umschalt+F2), dann C: die angepasste Kamera, an Ihrer Annotation gemessen</translation>
  </message>
  <message>
   <source>File &gt; Export as… writes the annotations for other programs: look at it</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Datei &gt; Exportieren als… schreibt die Annotationen für andere Programme: sehen Sie es an</translation>
  </message>
  <message>
   <source>That was the tour. Shift+F1: back to annotating; F1: all keys</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Das war der Rundgang. Umschalt+F1: zurück zum Annotieren; F1: alle Tasten</translation>
  </message>
  <message>
   <source>Go on to the next step</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Zum nächsten Schritt weitergehen</translation>
  </message>
  <message>
   <source>Esc ends the tour, too</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Auch Esc beendet den Rundgang</translation>
  </message>
  <message>
   <source>Skip</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Überspringen</translation>
  </message>
  <message>
   <source>End</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Beenden</translation>
  </message>
  <message>
   <source>the sample cannot be copied: {why}</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>das Beispiel lässt sich nicht kopieren: {why}</translation>
  </message>
  <message>
   <source>Drop a folder of pictures here</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Einen Ordner mit Bildern hierher ziehen</translation>
  </message>
  <message>
   <source>Annotations are read from and saved as JSON next to the pictures. Drop a folder of cameras later, to see them judged against your clicks.</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Annotationen werden als JSON neben den Bildern gelesen und gespeichert. Ein Ordner mit Kameras, später hierher gezogen, wird an Ihren Klicks gemessen.</translation>
  </message>
  <message>
   <source>Open recent</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Zuletzt geöffnet</translation>
  </message>
  <message>
   <source>Open folder…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_folder]</extracomment>
   <translation>Ordner öffnen…</translation>
  </message>
  <message>
   <source>Open picture…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_picture]</extracomment>
   <translation>Bild öffnen…</translation>
  </message>
  <message>
   <source>Open video…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_video]</extracomment>
   <translation>Video öffnen…</translation>
  </message>
  <message>
   <source>Try the sample</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Beispiel ausprobieren</translation>
  </message>
  <message>
   <source>Tour (60 seconds)</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action tour]</extracomment>
   <translation>Rundgang (60 Sekunden)</translation>
  </message>
  <message>
   <source>Go on with</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Weitermachen mit</translation>
  </message>
  <message>
   <source>Nothing was opened yet</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Noch nichts geöffnet</translation>
  </message>
  <message>
   <source>{setting}: back to {value}</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>{setting}: zurück auf {value}</translation>
  </message>
  <message>
   <source>No setting has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>Keine Einstellung hat „{text}“.</translation>
  </message>
  <message>
   <source>Settings</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>Einstellungen</translation>
  </message>
  <message>
   <source>Search the settings</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>Einstellungen durchsuchen</translation>
  </message>
  <message>
   <source>Reset all</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>Alle zurücksetzen</translation>
  </message>
  <message>
   <source>none of your own</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>kein eigener</translation>
  </message>
  <message>
   <source>Change keys…</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py, the action keymap]</extracomment>
   <translation>Tasten ändern…</translation>
  </message>
  <message>
   <source>Scores</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Bewertung</translation>
  </message>
  <message>
   <source>Fit</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Anpassung</translation>
  </message>
  <message>
   <source>Check</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Befunde</translation>
  </message>
  <message>
   <source>Plots</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py, the action plots]</extracomment>
   <translation>Diagramme</translation>
  </message>
  <message>
   <source>Review</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Durchsicht</translation>
  </message>
  <message>
   <source>Agreement</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Übereinstimmung</translation>
  </message>
  <message>
   <source>Annotate</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Annotieren</translation>
  </message>
  <message>
   <source>Judge</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Beurteilen</translation>
  </message>
  <message>
   <source>Review</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>Prüfen</translation>
  </message>
  <message>
   <source>Disagreement</source>
   <extracomment>[procc_annotator/interaction/camera_view.py, the action disagreement]</extracomment>
   <translation>Abweichung</translation>
  </message>
  <message>
   <source>Uncertainty</source>
   <extracomment>[procc_annotator/interaction/camera_view.py]</extracomment>
   <translation>Unsicherheit</translation>
  </message>
  <message numerus="yes">
   <source>{n} to go</source>
   <extracomment>{n} to go / {n} to go [procc_annotator/interaction/draw_tool.py]</extracomment>
   <translation>
    <numerusform>noch {n}</numerusform>
    <numerusform>noch {n}</numerusform>
   </translation>
  </message>
  <message>
   <source>choose an element first: field map, list, or its key</source>
   <extracomment>[procc_annotator/interaction/draw_tool.py]</extracomment>
   <translation>wählen Sie zuerst ein Element: Feldkarte, Liste oder Taste</translation>
  </message>
  <message>
   <source>{title} is pinned, so that a slip does not move it: drag its points, or unpin elements (Ctrl+P, menu Element) to drag it as a whole</source>
   <extracomment>[procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>{title} ist festgehalten, damit kein Ausrutscher es bewegt: ziehen Sie seine Punkte, oder lösen Sie die Elemente (Strg+P, Menü Element), um es im Ganzen zu ziehen</translation>
  </message>
  <message numerus="yes">
   <source>move {n} points</source>
   <extracomment>move {n} point / move {n} points [procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>
    <numerusform>{n} Punkt verschieben</numerusform>
    <numerusform>{n} Punkte verschieben</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>delete {n} points</source>
   <extracomment>delete {n} point / delete {n} points [procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>
    <numerusform>{n} Punkt löschen</numerusform>
    <numerusform>{n} Punkte löschen</numerusform>
   </translation>
  </message>
  <message>
   <source>draw {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} zeichnen</translation>
  </message>
  <message>
   <source>continue {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} fortsetzen</translation>
  </message>
  <message>
   <source>confirm {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} bestätigen</translation>
  </message>
  <message>
   <source>move {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} verschieben</translation>
  </message>
  <message>
   <source>move all of {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} ganz verschieben</translation>
  </message>
  <message>
   <source>nudge {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} rücken</translation>
  </message>
  <message>
   <source>insert a point in {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>einen Punkt in {title} einfügen</translation>
  </message>
  <message>
   <source>delete {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} löschen</translation>
  </message>
  <message>
   <source>delete point {number} of {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>Punkt {number} von {title} löschen</translation>
  </message>
  <message numerus="yes">
   <source>nudge {n} points</source>
   <extracomment>nudge {n} point / nudge {n} points [procc_annotator/interaction/gestures.py]</extracomment>
   <translation>
    <numerusform>{n} Punkt rücken</numerusform>
    <numerusform>{n} Punkte rücken</numerusform>
   </translation>
  </message>
  <message>
   <source>click to draw; choose its class afterwards</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>klicken, um zu zeichnen; die Klasse danach wählen</translation>
  </message>
  <message>
   <source>Backspace removes the last point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Rücktaste entfernt den letzten Punkt</translation>
  </message>
  <message>
   <source>click marks it and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Klick markiert es und geht weiter zu {title}</translation>
  </message>
  <message>
   <source>release drops it here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Loslassen legt es hier ab</translation>
  </message>
  <message>
   <source>click or drag a point, drag elsewhere to select several</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Punkt klicken oder ziehen, anderswo ziehen wählt mehrere</translation>
  </message>
  <message>
   <source>arrows nudge {step:g} px, with Shift {fine:g} px, Ctrl {far:g} px</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Pfeiltasten rücken {step:g} px, mit Umschalt {fine:g} px, Strg {far:g} px</translation>
  </message>
  <message>
   <source>Drop a folder of pictures here, or open one with Ctrl+O</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Einen Ordner mit Bildern hierher ziehen, oder mit Strg+O öffnen</translation>
  </message>
  <message>
   <source>Ctrl+Enter commits the frame and shows the projection</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Strg+Eingabe gibt das Bild ab und zeigt die Projektion</translation>
  </message>
  <message>
   <source>GHOST {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>GEIST {title}</translation>
  </message>
  <message>
   <source>GHOST the next one comes in a moment</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>GEIST der nächste kommt gleich</translation>
  </message>
  <message numerus="yes">
   <source>Tab: next of {n} ghosts</source>
   <extracomment>Tab: next of {n} ghost / Tab: next of {n} ghosts [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Tab: nächster von {n} Geist</numerusform>
    <numerusform>Tab: nächster von {n} Geistern</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>Tab: first of {n} ghosts</source>
   <extracomment>Tab: first of {n} ghost / Tab: first of {n} ghosts [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Tab: erster von {n} Geist</numerusform>
    <numerusform>Tab: erster von {n} Geistern</numerusform>
   </translation>
  </message>
  <message>
   <source>Shift+Enter: accept all</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Umschalt+Eingabe: alle annehmen</translation>
  </message>
  <message>
   <source>Enter accepts it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Eingabe nimmt ihn an</translation>
  </message>
  <message>
   <source>Tab goes on</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Tab geht weiter</translation>
  </message>
  <message>
   <source>. not visible here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>. hier nicht sichtbar</translation>
  </message>
  <message>
   <source>Esc goes back</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc geht zurück</translation>
  </message>
  <message>
   <source>/ finds an element</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>/ sucht ein Element</translation>
  </message>
  <message>
   <source>DRAW</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>ZEICHNEN</translation>
  </message>
  <message>
   <source>choose an element: field map, list, its key or /</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>ein Element wählen: Feldkarte, Liste, Taste oder /</translation>
  </message>
  <message numerus="yes">
   <source>DRAW a line, {n} points</source>
   <extracomment>DRAW a line, {n} point / DRAW a line, {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>ZEICHNEN eine Linie, {n} Punkt</numerusform>
    <numerusform>ZEICHNEN eine Linie, {n} Punkte</numerusform>
   </translation>
  </message>
  <message>
   <source>Enter or double-click finishes, then choose the class</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Eingabe oder Doppelklick beendet, dann die Klasse wählen</translation>
  </message>
  <message numerus="yes">
   <source>DRAW {title}, {n} points</source>
   <extracomment>DRAW {title}, {n} point / DRAW {title}, {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>ZEICHNEN {title}, {n} Punkt</numerusform>
    <numerusform>ZEICHNEN {title}, {n} Punkte</numerusform>
   </translation>
  </message>
  <message>
   <source>Enter or double-click finishes</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Eingabe oder Doppelklick beendet</translation>
  </message>
  <message>
   <source>click adds the second point and finishes</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Klick setzt den zweiten Punkt und beendet</translation>
  </message>
  <message>
   <source>click adds a point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Klick setzt einen Punkt</translation>
  </message>
  <message>
   <source>DRAW {title}, unconfirmed</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>ZEICHNEN {title}, unbestätigt</translation>
  </message>
  <message>
   <source>DRAW {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>ZEICHNEN {title}</translation>
  </message>
  <message>
   <source>Enter confirms it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Eingabe bestätigt es</translation>
  </message>
  <message>
   <source>choose it again, then clicks continue it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>erneut wählen, dann setzen Klicks es fort</translation>
  </message>
  <message numerus="yes">
   <source>click continues it after its {n} points</source>
   <extracomment>click continues it after its {n} point / click continues it after its {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Klick setzt es nach seinem {n} Punkt fort</numerusform>
    <numerusform>Klick setzt es nach seinen {n} Punkten fort</numerusform>
   </translation>
  </message>
  <message>
   <source>click starts it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Klick beginnt es</translation>
  </message>
  <message>
   <source>click moves it here and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Klick verschiebt es hierher und geht weiter zu {title}</translation>
  </message>
  <message>
   <source>Enter confirms {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Eingabe bestätigt {title}</translation>
  </message>
  <message numerus="yes">
   <source>Esc deselects {n} points</source>
   <extracomment>Esc deselects the point / Esc deselects {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Esc hebt die Auswahl des Punkts auf</numerusform>
    <numerusform>Esc hebt die Auswahl von {n} Punkten auf</numerusform>
   </translation>
  </message>
  <message>
   <source>EDIT</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>BEARBEITEN</translation>
  </message>
  <message>
   <source>release selects all points inside</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Loslassen wählt alle Punkte darin</translation>
  </message>
  <message>
   <source>EDIT point {number} of {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>BEARBEITEN Punkt {number} von {title}</translation>
  </message>
  <message>
   <source>release selects the element, which is pinned</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Loslassen wählt das Element, das festgehalten ist</translation>
  </message>
  <message>
   <source>EDIT the element</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>BEARBEITEN das Element</translation>
  </message>
  <message>
   <source>drag moves point {number} of {title}, Alt+Shift+click removes it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Ziehen bewegt Punkt {number} von {title}, Alt+Umschalt+Klick entfernt ihn</translation>
  </message>
  <message>
   <source>click selects {title}, Alt+click inserts a point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Klick wählt {title}, Alt+Klick fügt einen Punkt ein</translation>
  </message>
  <message>
   <source>click does nothing: there are no points to edit, draw an element first</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Klick tut nichts: es gibt keine Punkte zu bearbeiten, zeichnen Sie zuerst ein Element</translation>
  </message>
  <message>
   <source>click a point to drag it, elsewhere to deselect</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Punkt anklicken, um ihn zu ziehen, anderswo klicken hebt die Auswahl auf</translation>
  </message>
  <message numerus="yes">
   <source>Delete removes {n} points</source>
   <extracomment>Delete removes the point / Delete removes {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Entf entfernt den Punkt</numerusform>
    <numerusform>Entf entfernt {n} Punkte</numerusform>
   </translation>
  </message>
  <message>
   <source>click draws it by hand</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Klick zeichnet es von Hand</translation>
  </message>
  <message numerus="yes">
   <source>Enter accepts {n} points</source>
   <extracomment>Enter accepts {n} point / Enter accepts {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Eingabe nimmt {n} Punkt an</numerusform>
    <numerusform>Eingabe nimmt {n} Punkte an</numerusform>
   </translation>
  </message>
  <message>
   <source>no line found along it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>keine Linie darauf gefunden</translation>
  </message>
  <message>
   <source>an element's key names it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>die Taste eines Elements benennt sie</translation>
  </message>
  <message>
   <source>Enter or double-click finishes and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Eingabe oder Doppelklick beendet und geht weiter zu {title}</translation>
  </message>
  <message>
   <source>Esc cancels</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc bricht ab</translation>
  </message>
  <message>
   <source>Esc deselects</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc hebt die Auswahl auf</translation>
  </message>
  <message>
   <source>click moves it here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Klick verschiebt es hierher</translation>
  </message>
  <message>
   <source>click marks it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Klick markiert es</translation>
  </message>
  <message>
   <source>hold Ctrl: no snapping</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Strg halten: kein Einrasten</translation>
  </message>
  <message>
   <source>Delete removes {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Entf entfernt {title}</translation>
  </message>
  <message>
   <source>EDIT choosing points</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>BEARBEITEN Punkte wählen</translation>
  </message>
  <message numerus="yes">
   <source>EDIT {n} points</source>
   <extracomment>EDIT {n} point / EDIT {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>BEARBEITEN {n} Punkt</numerusform>
    <numerusform>BEARBEITEN {n} Punkte</numerusform>
   </translation>
  </message>
  <message>
   <source>READ ONLY</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>NUR LESEN</translation>
  </message>
  <message>
   <source>BLIND</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>BLIND</translation>
  </message>
  <message>
   <source>Shift+Enter finishes and stays</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Umschalt+Eingabe beendet und bleibt</translation>
  </message>
  <message>
   <source>Esc removes the new point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc entfernt den neuen Punkt</translation>
  </message>
  <message>
   <source>Esc lets go</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc lässt los</translation>
  </message>
  <message>
   <source>passes</source>
   <extracomment>[procc_annotator/interaction/legend.py, procc_annotator/interaction/palette.py]</extracomment>
   <translation>besteht</translation>
  </message>
  <message>
   <source>too far</source>
   <extracomment>[procc_annotator/interaction/legend.py, procc_annotator/interaction/palette.py]</extracomment>
   <translation>zu weit</translation>
  </message>
  <message>
   <source>annotated, not projected</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>annotiert, nicht projiziert</translation>
  </message>
  <message>
   <source>projected, not annotated</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>projiziert, nicht annotiert</translation>
  </message>
  <message>
   <source>ghost of an unsure camera</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>Geist einer unsicheren Kamera</translation>
  </message>
  <message>
   <source>ghost: expected here</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>Geist: hier erwartet</translation>
  </message>
  <message>
   <source>annotated, in its class's colour</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>annotiert, in der Farbe seiner Klasse</translation>
  </message>
  <message>
   <source>to be confirmed</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>zu bestätigen</translation>
  </message>
  <message>
   <source>projection</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>Projektion</translation>
  </message>
  <message>
   <source>second annotator</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>zweiter Annotator</translation>
  </message>
  <message>
   <source>no distance</source>
   <extracomment>[procc_annotator/interaction/overlay_primitives.py]</extracomment>
   <translation>kein Abstand</translation>
  </message>
  <message>
   <source>not annotated</source>
   <extracomment>[procc_annotator/interaction/palette.py]</extracomment>
   <translation>nicht annotiert</translation>
  </message>
  <message>
   <source>missed</source>
   <extracomment>[procc_annotator/interaction/palette.py]</extracomment>
   <translation>verfehlt</translation>
  </message>
  <message>
   <source>{element} agrees: its farthest point, {number}, is {px} px off; it passes at tau &gt; {px}.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} stimmt: sein fernster Punkt, {number}, liegt {px} px daneben; es besteht bei tau &gt; {px}.</translation>
  </message>
  <message>
   <source>{element} is too far: point {number} is {px} px off; it passes at tau &gt; {px}.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} ist zu weit: Punkt {number} liegt {px} px daneben; es besteht bei tau &gt; {px}.</translation>
  </message>
  <message>
   <source>{title} (judged as {other}, labels mirrored)</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{title} (beurteilt als {other}, Klassen gespiegelt)</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but the camera does not show it in the picture.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} ist verfehlt: es ist annotiert, aber die Kamera zeigt es nicht im Bild.</translation>
  </message>
  <message>
   <source>{element} is not annotated, but the camera shows it: a false positive.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} ist nicht annotiert, aber die Kamera zeigt es: falsch positiv.</translation>
  </message>
  <message>
   <source>{element} is too far: point {number} has no distance, because the projection has coinciding samples there; it passes at no tau.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} ist zu weit: Punkt {number} hat keinen Abstand, weil die Projektion dort zusammenfallende Stützpunkte hat; es besteht bei keinem tau.</translation>
  </message>
  <message>
   <source>As it goes on beyond the picture it is at most {px} px off, but soccernet measures to what is in the picture alone.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>So, wie es jenseits des Bildes weitergeht, liegt es höchstens {px} px daneben, aber soccernet misst nur bis zu dem, was im Bild ist.</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but the field has no such element to project.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} ist verfehlt: es ist annotiert, aber das Feld hat kein solches Element zu projizieren.</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but it leaves the ground, and the camera knows only the ground.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} ist verfehlt: es ist annotiert, aber es verlässt den Boden, und die Kamera kennt nur den Boden.</translation>
  </message>
  <message>
   <source>Annotate all pictures of a folder</source>
   <extracomment>[the action open_folder]</extracomment>
   <translation>Alle Bilder eines Ordners annotieren</translation>
  </message>
  <message>
   <source>Annotate a single picture</source>
   <extracomment>[the action open_picture]</extracomment>
   <translation>Ein einzelnes Bild annotieren</translation>
  </message>
  <message>
   <source>Annotate frames of a video without extracting them first</source>
   <extracomment>[the action open_video]</extracomment>
   <translation>Bilder eines Videos annotieren, ohne sie vorher herauszuschreiben</translation>
  </message>
  <message>
   <source>Season…</source>
   <extracomment>[the action season]</extracomment>
   <translation>Saison …</translation>
  </message>
  <message>
   <source>List the matches of a season (a folder in which videos lie) to open one of them</source>
   <extracomment>[the action season]</extracomment>
   <translation>Die Spiele einer Saison (eines Ordners, in dem Videos liegen) auflisten, um eines zu öffnen</translation>
  </message>
  <message>
   <source>Open the sample</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>Beispiel öffnen</translation>
  </message>
  <message>
   <source>Open your own copy of the frames that come with the program</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>Eine eigene Kopie der mitgelieferten Bilder öffnen</translation>
  </message>
  <message>
   <source>Open second annotator…</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>Zweiten Annotator öffnen…</translation>
  </message>
  <message>
   <source>Draw and compare what another annotator clicked in the same frames</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>Zeichnen und vergleichen, was jemand anders in denselben Bildern geklickt hat</translation>
  </message>
  <message>
   <source>Close second annotator</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>Zweiten Annotator schließen</translation>
  </message>
  <message>
   <source>Show only the annotations of this dataset again</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>Wieder nur die Annotationen dieses Datensatzes zeigen</translation>
  </message>
  <message>
   <source>From a file…</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>Aus einer Datei…</translation>
  </message>
  <message>
   <source>A description of your own: any sport, see the user guide</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>Eine eigene Beschreibung: jede Sportart, siehe Handbuch</translation>
  </message>
  <message>
   <source>Switch to the field that fits</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>Zum passenden Feld wechseln</translation>
  </message>
  <message>
   <source>Show the field that knows the classes annotated in this frame</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>Das Feld zeigen, das die in diesem Bild annotierten Klassen kennt</translation>
  </message>
  <message>
   <source>Read the file again</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>Datei neu lesen</translation>
  </message>
  <message>
   <source>Done by itself when the file of this dataset's field is written</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>Geschieht von selbst, wenn die Felddatei dieses Datensatzes geschrieben wird</translation>
  </message>
  <message>
   <source>Save now</source>
   <extracomment>[the action save]</extracomment>
   <translation>Jetzt speichern</translation>
  </message>
  <message>
   <source>Every finished edit is saved at once; this tries again what failed</source>
   <extracomment>[the action save]</extracomment>
   <translation>Jede fertige Änderung wird sofort gespeichert; dies versucht noch einmal, was misslang</translation>
  </message>
  <message>
   <source>Write what could not be saved in its own place to another folder</source>
   <extracomment>[the action save_copies]</extracomment>
   <translation>In einen anderen Ordner schreiben, was sich am eigenen Ort nicht speichern ließ</translation>
  </message>
  <message>
   <source>Import annotations…</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>Annotationen importieren…</translation>
  </message>
  <message>
   <source>Take annotations of another program or dataset into this one, frame by frame</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>Annotationen eines anderen Programms oder Datensatzes Bild für Bild übernehmen</translation>
  </message>
  <message>
   <source>Export as…</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>Exportieren als…</translation>
  </message>
  <message>
   <source>Write the annotations for another program: CVAT, labelme, COCO, SoccerNet, masks</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>Die Annotationen für ein anderes Programm schreiben: CVAT, labelme, COCO, SoccerNet, Masken</translation>
  </message>
  <message>
   <source>Export annotations as JSON…</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>Annotationen als JSON exportieren…</translation>
  </message>
  <message>
   <source>Write the annotations of all frames as a folder or zip of JSON files</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>Die Annotationen aller Bilder als Ordner oder Zip mit JSON-Dateien schreiben</translation>
  </message>
  <message>
   <source>Export JaC of the set…</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>JaC des Satzes exportieren…</translation>
  </message>
  <message>
   <source>Write the JaC of every frame as CSV or JSON</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>Den JaC jedes Bildes als CSV oder JSON schreiben</translation>
  </message>
  <message>
   <source>Export provenance…</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>Herkunft exportieren…</translation>
  </message>
  <message>
   <source>Write how every point came to be, and through whom, as a sidecar JSON</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>Als begleitendes JSON schreiben, wie und durch wen jeder Punkt entstand</translation>
  </message>
  <message>
   <source>Save overlay picture…</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>Bild mit Überlagerung speichern…</translation>
  </message>
  <message>
   <source>Write the picture with annotation and projection as PNG, JPEG or SVG, with a legend</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>Das Bild mit Annotation und Projektion samt Legende als PNG, JPEG oder SVG schreiben</translation>
  </message>
  <message>
   <source>Export overview…</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>Übersicht exportieren…</translation>
  </message>
  <message>
   <source>Write status, counts and time of every frame as CSV</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>Status, Anzahlen und Zeit jedes Bildes als CSV schreiben</translation>
  </message>
  <message>
   <source>Export verdicts…</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>Urteile exportieren…</translation>
  </message>
  <message>
   <source>Write who is at fault in which frame, with JaC and largest error, as CSV</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>Als CSV schreiben, woran es in welchem Bild liegt, mit JaC und größtem Fehler</translation>
  </message>
  <message>
   <source>Export findings…</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>Befunde exportieren…</translation>
  </message>
  <message>
   <source>Write what the label check found in the frames checked so far, as CSV</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>Als CSV schreiben, was die Klassenprüfung in den bisher geprüften Bildern fand</translation>
  </message>
  <message>
   <source>Author name…</source>
   <extracomment>[the action author]</extracomment>
   <translation>Name des Autors…</translation>
  </message>
  <message>
   <source>The name your points, comments and versions bear</source>
   <extracomment>[the action author]</extracomment>
   <translation>Der Name, den Ihre Punkte, Kommentare und Fassungen tragen</translation>
  </message>
  <message>
   <source>Quit</source>
   <extracomment>[the action quit]</extracomment>
   <translation>Beenden</translation>
  </message>
  <message>
   <source>Close the window; everything is saved</source>
   <extracomment>[the action quit]</extracomment>
   <translation>Das Fenster schließen; alles ist gespeichert</translation>
  </message>
  <message>
   <source>Undo</source>
   <extracomment>[the action undo]</extracomment>
   <translation>Rückgängig</translation>
  </message>
  <message>
   <source>Take back the last step of this frame</source>
   <extracomment>[the action undo]</extracomment>
   <translation>Den letzten Schritt in diesem Bild zurücknehmen</translation>
  </message>
  <message>
   <source>Redo</source>
   <extracomment>[the action redo]</extracomment>
   <translation>Wiederholen</translation>
  </message>
  <message>
   <source>Do the step again</source>
   <extracomment>[the action redo]</extracomment>
   <translation>Den Schritt noch einmal tun</translation>
  </message>
  <message>
   <source>Delete point or element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>Punkt oder Element löschen</translation>
  </message>
  <message>
   <source>Remove the selected point; without one, the selected element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>Den gewählten Punkt entfernen; ohne einen das gewählte Element</translation>
  </message>
  <message>
   <source>Insert point</source>
   <extracomment>[the action insert_point]</extracomment>
   <translation>Punkt einfügen</translation>
  </message>
  <message>
   <source>Put a point on the line at the crosshair, or at the mouse (Alt and a click do it, too)</source>
   <extracomment>[the action insert_point]</extracomment>
   <translation>Einen Punkt auf die Linie am Fadenkreuz setzen, oder an der Maus (Alt und ein Klick tun es auch)</translation>
  </message>
  <message>
   <source>Choose all points</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>Alle Punkte wählen</translation>
  </message>
  <message>
   <source>Choose all points of the selected element, or of the frame</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>Alle Punkte des gewählten Elements wählen, oder alle des Bildes</translation>
  </message>
  <message>
   <source>Drop the points just clicked, then let go of the selection</source>
   <extracomment>[the action cancel]</extracomment>
   <translation>Die eben geklickten Punkte verwerfen, dann die Auswahl aufheben</translation>
  </message>
  <message>
   <source>Settings…</source>
   <extracomment>[the action settings]</extracomment>
   <translation>Einstellungen…</translation>
  </message>
  <message>
   <source>Theme, text size, and how the window draws, fits and judges</source>
   <extracomment>[the action settings]</extracomment>
   <translation>Farbschema, Textgröße, und wie das Fenster zeichnet, anpasst und urteilt</translation>
  </message>
  <message>
   <source>By the arrows</source>
   <extracomment>[the menus]</extracomment>
   <translation>Mit den Pfeiltasten</translation>
  </message>
  <message>
   <source>Left 1 px</source>
   <extracomment>[the action nudge_left]</extracomment>
   <translation>1 px nach links</translation>
  </message>
  <message>
   <source>Move the chosen points 1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down, the action nudge_left, the action nudge_right]</extracomment>
   <translation>Die gewählten Punkte 1 px verschieben; ist keiner gewählt, das Fadenkreuz</translation>
  </message>
  <message>
   <source>Right 1 px</source>
   <extracomment>[the action nudge_right]</extracomment>
   <translation>1 px nach rechts</translation>
  </message>
  <message>
   <source>Up 1 px</source>
   <extracomment>[the action nudge_up]</extracomment>
   <translation>1 px nach oben</translation>
  </message>
  <message>
   <source>Down 1 px</source>
   <extracomment>[the action nudge_down]</extracomment>
   <translation>1 px nach unten</translation>
  </message>
  <message>
   <source>Left 0.1 px</source>
   <extracomment>[the action nudge_left_fine]</extracomment>
   <translation>0.1 px nach links</translation>
  </message>
  <message>
   <source>Move the chosen points 0.1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_fine, the action nudge_left_fine, the action nudge_right_fine]</extracomment>
   <translation>Die gewählten Punkte 0.1 px verschieben; ist keiner gewählt, das Fadenkreuz</translation>
  </message>
  <message>
   <source>Right 0.1 px</source>
   <extracomment>[the action nudge_right_fine]</extracomment>
   <translation>0.1 px nach rechts</translation>
  </message>
  <message>
   <source>Up 0.1 px</source>
   <extracomment>[the action nudge_up_fine]</extracomment>
   <translation>0.1 px nach oben</translation>
  </message>
  <message>
   <source>Down 0.1 px</source>
   <extracomment>[the action nudge_down_fine]</extracomment>
   <translation>0.1 px nach unten</translation>
  </message>
  <message>
   <source>Left 10 px</source>
   <extracomment>[the action nudge_left_far]</extracomment>
   <translation>10 px nach links</translation>
  </message>
  <message>
   <source>Move the chosen points 10 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_far, the action nudge_left_far, the action nudge_right_far]</extracomment>
   <translation>Die gewählten Punkte 10 px verschieben; ist keiner gewählt, das Fadenkreuz</translation>
  </message>
  <message>
   <source>Right 10 px</source>
   <extracomment>[the action nudge_right_far]</extracomment>
   <translation>10 px nach rechts</translation>
  </message>
  <message>
   <source>Up 10 px</source>
   <extracomment>[the action nudge_up_far]</extracomment>
   <translation>10 px nach oben</translation>
  </message>
  <message>
   <source>Down 10 px</source>
   <extracomment>[the action nudge_down_far]</extracomment>
   <translation>10 px nach unten</translation>
  </message>
  <message>
   <source>Left 100 px</source>
   <extracomment>[the action nudge_left_farther]</extracomment>
   <translation>100 px nach links</translation>
  </message>
  <message>
   <source>Move the chosen points 100 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_farther, the action nudge_left_farther, the action nudge_right_farther]</extracomment>
   <translation>Die gewählten Punkte 100 px verschieben; ist keiner gewählt, das Fadenkreuz</translation>
  </message>
  <message>
   <source>Right 100 px</source>
   <extracomment>[the action nudge_right_farther]</extracomment>
   <translation>100 px nach rechts</translation>
  </message>
  <message>
   <source>Up 100 px</source>
   <extracomment>[the action nudge_up_farther]</extracomment>
   <translation>100 px nach oben</translation>
  </message>
  <message>
   <source>Down 100 px</source>
   <extracomment>[the action nudge_down_farther]</extracomment>
   <translation>100 px nach unten</translation>
  </message>
  <message>
   <source>Next frame</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>Nächstes Bild</translation>
  </message>
  <message>
   <source>Show the next picture, of those that the filter shows</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>Das nächste Bild zeigen, unter denen, die der Filter zeigt</translation>
  </message>
  <message>
   <source>Previous frame</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>Voriges Bild</translation>
  </message>
  <message>
   <source>Show the previous picture, of those that the filter shows</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>Das vorige Bild zeigen, unter denen, die der Filter zeigt</translation>
  </message>
  <message>
   <source>Next unfinished</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>Nächstes unfertiges</translation>
  </message>
  <message>
   <source>Go on to the next frame that is neither done nor approved</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>Zum nächsten Bild, das weder fertig noch freigegeben ist</translation>
  </message>
  <message>
   <source>Previous unfinished</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>Voriges unfertiges</translation>
  </message>
  <message>
   <source>Go back to the frame before that is neither done nor approved</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>Zurück zum vorigen Bild, das weder fertig noch freigegeben ist</translation>
  </message>
  <message>
   <source>Go to</source>
   <extracomment>[the menus]</extracomment>
   <translation>Gehen zu</translation>
  </message>
  <message>
   <source>Next rejected</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>Nächstes abgelehntes</translation>
  </message>
  <message>
   <source>Go on to the next frame that a reviewer sent back</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>Zum nächsten Bild, das ein Prüfer zurückgegeben hat</translation>
  </message>
  <message>
   <source>Next worst JaC</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>Nächstschlechtester JaC</translation>
  </message>
  <message>
   <source>The frame with the lowest JaC; once more: the next better one</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>Das Bild mit dem niedrigsten JaC; noch einmal: das nächstbessere</translation>
  </message>
  <message>
   <source>Next largest error</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>Nächstgrößter Fehler</translation>
  </message>
  <message>
   <source>The frame with the largest error of a point; once more: the next smaller one</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>Das Bild mit dem größten Fehler eines Punktes; noch einmal: das mit dem nächstkleineren</translation>
  </message>
  <message>
   <source>Next by disagreement</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>Nächstes nach Abweichung</translation>
  </message>
  <message>
   <source>The frame where the active source and the compared one are farthest apart on the ground; once more: the next</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>Das Bild, in dem die aktive Quelle und die verglichene am Boden am weitesten auseinanderliegen; noch einmal: das nächste</translation>
  </message>
  <message>
   <source>Label check</source>
   <extracomment>[the menus]</extracomment>
   <translation>Klassenprüfung</translation>
  </message>
  <message>
   <source>Next finding</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>Nächster Befund</translation>
  </message>
  <message>
   <source>Go to the next thing the label check found, from frame to frame</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>Zum nächsten, was die Klassenprüfung fand, Bild für Bild</translation>
  </message>
  <message>
   <source>Previous finding</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>Voriger Befund</translation>
  </message>
  <message>
   <source>Go back to the finding before</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>Zurück zum vorigen Befund</translation>
  </message>
  <message>
   <source>Do the first remedy</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>Erste Abhilfe ausführen</translation>
  </message>
  <message>
   <source>Mend the current finding: relabel, swap, remove the bad point, or look at it</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>Den aktuellen Befund beheben: umbenennen, tauschen, den falschen Punkt entfernen, oder ansehen</translation>
  </message>
  <message>
   <source>Next without annotation</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>Nächstes ohne Annotation</translation>
  </message>
  <message>
   <source>Go to the next frame without annotations</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>Zum nächsten Bild, in dem nichts annotiert ist</translation>
  </message>
  <message>
   <source>Previous without annotation</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>Voriges ohne Annotation</translation>
  </message>
  <message>
   <source>Go to the previous frame without annotations</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>Zurück zum vorigen Bild, in dem nichts annotiert ist</translation>
  </message>
  <message>
   <source>First frame</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>Erstes Bild</translation>
  </message>
  <message>
   <source>Show the first picture</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>Das erste Bild zeigen</translation>
  </message>
  <message>
   <source>Last frame</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>Letztes Bild</translation>
  </message>
  <message>
   <source>Show the last picture</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>Das letzte Bild zeigen</translation>
  </message>
  <message>
   <source>Shot</source>
   <extracomment>[the menus]</extracomment>
   <translation>Einstellung</translation>
  </message>
  <message>
   <source>Follow the shot</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>Der Einstellung folgen</translation>
  </message>
  <message>
   <source>Find the cameras of all frames of this shot, from this one in both directions; once more stops</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>Die Kameras aller Bilder dieser Einstellung finden, von diesem aus in beide Richtungen; noch einmal hält an</translation>
  </message>
  <message>
   <source>Accept the stretch</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>Abschnitt annehmen</translation>
  </message>
  <message>
   <source>Annotate the frames of the shot, or of the stretch marked on the strip, along their track; annotated ones are left out, and doubtful ones unless it is pressed again</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>Annotiert die Bilder der Einstellung oder des auf dem Streifen markierten Abschnitts entlang ihrer Spur; annotierte werden ausgelassen, zweifelhafte auch, wenn es nicht noch einmal gedrückt wird</translation>
  </message>
  <message>
   <source>Annotate all that is sure</source>
   <extracomment>[the action annotate_sure]</extracomment>
   <translation>Alles Sichere annotieren</translation>
  </message>
  <message>
   <source>Annotate every frame of the dataset whose camera is found and sure, in one step; Next doubtful frame (Alt+PgDown) then goes through the others, the least sure first</source>
   <extracomment>[the action annotate_sure]</extracomment>
   <translation>Jedes Bild des Datensatzes, dessen Kamera gefunden und sicher ist, in einem Schritt annotieren; „Nächstes zweifelhaftes Bild“ (Alt+Bild ab) geht dann die übrigen durch, unsicherste zuerst</translation>
  </message>
  <message>
   <source>Take back what was accepted last</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>Zuletzt Angenommenes zurücknehmen</translation>
  </message>
  <message>
   <source>Frames that were accepted last and not edited since are as they were before</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>Zuletzt angenommene und seither nicht bearbeitete Bilder werden wieder, wie sie waren</translation>
  </message>
  <message>
   <source>Ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>Zehn Bilder weiter</translation>
  </message>
  <message>
   <source>Go ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>Zehn Bilder weitergehen</translation>
  </message>
  <message>
   <source>Ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>Zehn Bilder zurück</translation>
  </message>
  <message>
   <source>Go ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>Zehn Bilder zurückgehen</translation>
  </message>
  <message>
   <source>Next annotated frame</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>Nächstes annotiertes Bild</translation>
  </message>
  <message>
   <source>Go on to the next frame that is annotated</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>Zum nächsten annotierten Bild</translation>
  </message>
  <message>
   <source>Previous annotated frame</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>Voriges annotiertes Bild</translation>
  </message>
  <message>
   <source>Go back to the annotated frame before</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>Zurück zum vorigen annotierten Bild</translation>
  </message>
  <message>
   <source>Next doubtful frame</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>Nächstes zweifelhaftes Bild</translation>
  </message>
  <message>
   <source>Go to the next frame whose track should be checked</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>Zum nächsten Bild, dessen Spur angesehen werden sollte</translation>
  </message>
  <message>
   <source>Previous doubtful frame</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>Voriges zweifelhaftes Bild</translation>
  </message>
  <message>
   <source>Go back to the doubtful frame before</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>Zurück zum vorigen zweifelhaften Bild</translation>
  </message>
  <message>
   <source>Play or pause</source>
   <extracomment>[the action play]</extracomment>
   <translation>Abspielen oder anhalten</translation>
  </message>
  <message>
   <source>Show the frames one after the other; once more, or any edit, stops</source>
   <extracomment>[the action play]</extracomment>
   <translation>Die Bilder nacheinander zeigen; noch einmal, oder jede Änderung, hält an</translation>
  </message>
  <message>
   <source>Find frame…</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>Bild suchen…</translation>
  </message>
  <message>
   <source>Type a part of the frame's name</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>Einen Teil des Bildnamens tippen</translation>
  </message>
  <message>
   <source>Blind mode</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>Blindmodus</translation>
  </message>
  <message>
   <source>Hide the projection until the frame is committed, so that the camera cannot pull the clicks</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>Die Projektion verbergen, bis das Bild abgegeben ist, damit die Kamera die Klicks nicht beeinflusst</translation>
  </message>
  <message>
   <source>Lock the dataset to blind mode</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>Datensatz auf Blindmodus festlegen</translation>
  </message>
  <message>
   <source>Blind mode for everybody who annotates this dataset; unlocking asks, and is recorded</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>Blindmodus für alle, die diesen Datensatz annotieren; das Aufheben fragt nach und wird vermerkt</translation>
  </message>
  <message>
   <source>Done</source>
   <extracomment>[the action commit]</extracomment>
   <translation>Fertig</translation>
  </message>
  <message>
   <source>This frame is done; in blind mode that shows the projection</source>
   <extracomment>[the action commit]</extracomment>
   <translation>Dieses Bild ist fertig; im Blindmodus zeigt das die Projektion</translation>
  </message>
  <message>
   <source>A reviewer finds this frame right</source>
   <extracomment>[the action approve]</extracomment>
   <translation>Ein Prüfer befindet dieses Bild für richtig</translation>
  </message>
  <message>
   <source>A reviewer sends this frame back; say why in a comment</source>
   <extracomment>[the action reject]</extracomment>
   <translation>Ein Prüfer gibt dieses Bild zurück; der Grund gehört in einen Kommentar</translation>
  </message>
  <message>
   <source>In progress again</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>Wieder in Arbeit</translation>
  </message>
  <message>
   <source>This frame is not done after all</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>Dieses Bild ist doch nicht fertig</translation>
  </message>
  <message>
   <source>Comment…</source>
   <extracomment>[the action comment]</extracomment>
   <translation>Kommentar…</translation>
  </message>
  <message>
   <source>Write to the thread of this frame</source>
   <extracomment>[the action comment]</extracomment>
   <translation>Etwas zu diesem Bild schreiben</translation>
  </message>
  <message>
   <source>Comment on this place…</source>
   <extracomment>[the action comment_here]</extracomment>
   <translation>Kommentar zu dieser Stelle…</translation>
  </message>
  <message>
   <source>Write a comment on the place at the cursor; a numbered pin marks it in the picture</source>
   <extracomment>[the action comment_here]</extracomment>
   <translation>Einen Kommentar zur Stelle am Mauszeiger schreiben; eine nummerierte Nadel markiert sie im Bild</translation>
  </message>
  <message>
   <source>Earlier versions…</source>
   <extracomment>[the action versions]</extracomment>
   <translation>Frühere Fassungen…</translation>
  </message>
  <message>
   <source>Look at every saved version of this frame and bring one back</source>
   <extracomment>[the action versions]</extracomment>
   <translation>Alle gespeicherten Fassungen dieses Bildes ansehen und eine zurückholen</translation>
  </message>
  <message>
   <source>Group views…</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>Ansichten gruppieren…</translation>
  </message>
  <message>
   <source>Say by their names which frames show one instant from different cameras</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>Über die Namen sagen, welche Bilder denselben Augenblick aus verschiedenen Kameras zeigen</translation>
  </message>
  <message>
   <source>Keep this video frame</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>Dieses Videobild behalten</translation>
  </message>
  <message>
   <source>Write the frame of the video as a picture next to its annotation</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>Das Bild des Videos als Bilddatei neben seine Annotation schreiben</translation>
  </message>
  <message>
   <source>Copy from the previous frame</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>Vom vorigen Bild kopieren</translation>
  </message>
  <message>
   <source>Take over elements of the frame annotated before, moved as the camera moved; they wait to be confirmed</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>Elemente des zuvor annotierten Bildes übernehmen, verschoben wie die Kamera; sie warten auf Bestätigung</translation>
  </message>
  <message>
   <source>Confirm all unconfirmed elements</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>Alle unbestätigten Elemente bestätigen</translation>
  </message>
  <message>
   <source>Copied and unfinished elements count and are saved from now on</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>Kopierte und unfertige Elemente zählen und werden ab jetzt gespeichert</translation>
  </message>
  <message>
   <source>Drop unconfirmed elements</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>Unbestätigte Elemente verwerfen</translation>
  </message>
  <message>
   <source>Remove copied and unfinished elements that were not edited</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>Kopierte und unfertige Elemente entfernen, die nicht bearbeitet wurden</translation>
  </message>
  <message>
   <source>Regularise all elements</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>Alle Elemente begradigen</translation>
  </message>
  <message>
   <source>Resample every element of the frame along its painted line</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>Jedes Element des Bildes entlang seiner gemalten Linie neu abtasten</translation>
  </message>
  <message>
   <source>Draw</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>Zeichnen</translation>
  </message>
  <message>
   <source>Clicks add points to the chosen element</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>Klicks fügen dem gewählten Element Punkte hinzu</translation>
  </message>
  <message>
   <source>Drag, insert and remove points</source>
   <extracomment>[the action edit_mode]</extracomment>
   <translation>Punkte ziehen, einfügen und entfernen</translation>
  </message>
  <message>
   <source>Switch between draw and edit</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>Zwischen Zeichnen und Bearbeiten wechseln</translation>
  </message>
  <message>
   <source>From drawing to editing and back</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>Vom Zeichnen zum Bearbeiten und zurück</translation>
  </message>
  <message>
   <source>Next element</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>Nächstes Element</translation>
  </message>
  <message>
   <source>Choose the next element of the field</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>Das nächste Element des Feldes wählen</translation>
  </message>
  <message>
   <source>Previous element</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>Voriges Element</translation>
  </message>
  <message>
   <source>Choose the element before</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>Das vorige Element wählen</translation>
  </message>
  <message>
   <source>Find element…</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>Element suchen…</translation>
  </message>
  <message>
   <source>Type a part of the element's name</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>Einen Teil des Elementnamens tippen</translation>
  </message>
  <message>
   <source>Finish element</source>
   <extracomment>[the action finish]</extracomment>
   <translation>Element beenden</translation>
  </message>
  <message>
   <source>Make the points just clicked an element (or double-click the last one)</source>
   <extracomment>[the action finish]</extracomment>
   <translation>Die eben geklickten Punkte zu einem Element machen (oder den letzten doppelt klicken)</translation>
  </message>
  <message>
   <source>Finish and stay</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>Beenden und bleiben</translation>
  </message>
  <message>
   <source>Finish the element without going on to the next one</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>Das Element beenden, ohne zum nächsten zu gehen</translation>
  </message>
  <message>
   <source>Remove the last point</source>
   <extracomment>[the action back]</extracomment>
   <translation>Letzten Punkt entfernen</translation>
  </message>
  <message>
   <source>Remove the point clicked last</source>
   <extracomment>[the action back]</extracomment>
   <translation>Den zuletzt geklickten Punkt entfernen</translation>
  </message>
  <message>
   <source>Delete element</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>Element löschen</translation>
  </message>
  <message>
   <source>Remove the selected element with all its points</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>Das gewählte Element mit allen Punkten entfernen</translation>
  </message>
  <message>
   <source>Confirm element</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>Element bestätigen</translation>
  </message>
  <message>
   <source>The selected element counts and is saved from now on (in edit mode: Enter)</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>Das gewählte Element zählt und wird ab jetzt gespeichert (beim Bearbeiten: Eingabe)</translation>
  </message>
  <message>
   <source>Regularise</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>Begradigen</translation>
  </message>
  <message>
   <source>Resample the element along its painted line: two clicks make a straight element, five a curve</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>Das Element entlang seiner gemalten Linie neu abtasten: zwei Klicks ergeben ein gerades, fünf ein gebogenes Element</translation>
  </message>
  <message>
   <source>Close gaps</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>Lücken schließen</translation>
  </message>
  <message>
   <source>Let the element's ends reach the corner or the picture's edge they fall short of</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>Die Enden des Elements bis zur Ecke oder zum Bildrand verlängern, die sie verfehlen</translation>
  </message>
  <message>
   <source>Reverse</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>Umkehren</translation>
  </message>
  <message>
   <source>Turn the order of the element's points round</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>Die Reihenfolge der Punkte des Elements umdrehen</translation>
  </message>
  <message>
   <source>Duplicate to the symmetric class</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>In die symmetrische Klasse kopieren</translation>
  </message>
  <message>
   <source>Put a copy under the class of the turned field, to be dragged to its place</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>Eine Kopie unter der Klasse des gedrehten Feldes anlegen, um sie an ihren Platz zu ziehen</translation>
  </message>
  <message>
   <source>Snap to lines</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>An Linien einrasten</translation>
  </message>
  <message>
   <source>Clicks near a painted line go to its centre (hold Ctrl to click off it)</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>Klicks nahe einer gemalten Linie gehen auf deren Mitte (Strg halten, um daneben zu klicken)</translation>
  </message>
  <message>
   <source>Go on to the next element</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>Zum nächsten Element weitergehen</translation>
  </message>
  <message>
   <source>After finishing an element, choose the one that most likely comes next</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>Nach dem Beenden eines Elements das wahrscheinlich nächste wählen</translation>
  </message>
  <message>
   <source>Two clicks finish a straight element</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>Zwei Klicks beenden ein gerades Element</translation>
  </message>
  <message>
   <source>The second click on a straight element finishes it</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>Der zweite Klick auf einem geraden Element beendet es</translation>
  </message>
  <message>
   <source>Draw first, name after</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>Erst zeichnen, dann benennen</translation>
  </message>
  <message>
   <source>Without an element chosen, a click begins a line; once it is finished, the likeliest elements are offered at the pen</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>Ohne gewähltes Element beginnt ein Klick eine Linie; ist sie fertig, werden am Stift die wahrscheinlichsten Elemente angeboten</translation>
  </message>
  <message>
   <source>Pin elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>Elemente festhalten</translation>
  </message>
  <message>
   <source>Only points can be dragged, no whole elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>Nur Punkte lassen sich ziehen, keine ganzen Elemente</translation>
  </message>
  <message>
   <source>Ghosts</source>
   <extracomment>[the menus]</extracomment>
   <translation>Geister</translation>
  </message>
  <message>
   <source>Next ghost</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>Nächster Geist</translation>
  </message>
  <message>
   <source>Look closely at the next element the fitted camera expects</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>Das nächste Element ansehen, das die angepasste Kamera erwartet</translation>
  </message>
  <message>
   <source>Previous ghost</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>Voriger Geist</translation>
  </message>
  <message>
   <source>Look closely at the one before</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>Das vorige ansehen</translation>
  </message>
  <message>
   <source>Accept ghost</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>Geist annehmen</translation>
  </message>
  <message>
   <source>Make the ghost an element: points on its painted line, none where that is hidden (Enter)</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>Den Geist zum Element machen: Punkte auf seiner gemalten Linie, keine, wo sie verdeckt ist (Eingabe)</translation>
  </message>
  <message>
   <source>Accept all ghosts</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>Alle Geister annehmen</translation>
  </message>
  <message>
   <source>Accept all ghosts whose painted lines are seen well enough (Shift+Enter while nothing is being drawn)</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>Alle Geister annehmen, deren gemalte Linien gut genug zu sehen sind (Umschalt+Eingabe, solange nichts gezeichnet wird)</translation>
  </message>
  <message>
   <source>Accept all and go on</source>
   <extracomment>[the action accept_go_on]</extracomment>
   <translation>Alle annehmen und weiter</translation>
  </message>
  <message>
   <source>Accept all ghosts of this frame and show the next one: one key a frame</source>
   <extracomment>[the action accept_go_on]</extracomment>
   <translation>Alle Geister dieses Bildes annehmen und das nächste zeigen: eine Taste je Bild</translation>
  </message>
  <message>
   <source>Line seen to accept all…</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>Sichtbarer Teil, um alle anzunehmen…</translation>
  </message>
  <message>
   <source>How much of its painted line must be seen for a ghost to be accepted with all others</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>Wie viel der gemalten Linie eines Geistes zu sehen sein muss, damit er mit allen angenommen wird</translation>
  </message>
  <message>
   <source>The ghost or the chosen element cannot be seen in this frame; once more takes it back</source>
   <extracomment>[the action not_visible]</extracomment>
   <translation>Der Geist oder das gewählte Element ist in diesem Bild nicht zu sehen; noch einmal nimmt es zurück</translation>
  </message>
  <message>
   <source>Take back “not visible here”</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>„Hier nicht sichtbar“ zurücknehmen</translation>
  </message>
  <message>
   <source>The element said last to be not visible in this frame may be seen after all</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>Das Element, das zuletzt als nicht sichtbar galt, ist vielleicht doch zu sehen</translation>
  </message>
  <message>
   <source>Show ghosts</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>Geister zeigen</translation>
  </message>
  <message>
   <source>Draw faint curves where the fitted camera expects elements that are not annotated yet</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>Blasse Kurven zeichnen, wo die angepasste Kamera noch nicht annotierte Elemente erwartet</translation>
  </message>
  <message>
   <source>Look for the camera in the picture</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>Kamera im Bild suchen</translation>
  </message>
  <message>
   <source>Where nothing is annotated yet, find the camera without a click and show its elements as ghosts; nothing is saved before it is accepted</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>Wo noch nichts annotiert ist, die Kamera ohne Klick finden und ihre Elemente als Geister zeigen; gespeichert wird nichts, bevor es angenommen ist</translation>
  </message>
  <message>
   <source>Say what to annotate next</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>Sagen, was als Nächstes zu annotieren ist</translation>
  </message>
  <message>
   <source>Mark on the field map the element that would make the fitted camera surest</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>Auf der Feldkarte das Element markieren, das die angepasste Kamera am sichersten machte</translation>
  </message>
  <message>
   <source>Fit to window</source>
   <extracomment>[the action fit]</extracomment>
   <translation>In Fenster einpassen</translation>
  </message>
  <message>
   <source>Show the whole picture</source>
   <extracomment>[the action fit]</extracomment>
   <translation>Das ganze Bild zeigen</translation>
  </message>
  <message>
   <source>Actual size</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>Originalgröße</translation>
  </message>
  <message>
   <source>One picture pixel is one screen pixel</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>Ein Bildpixel ist ein Bildschirmpixel</translation>
  </message>
  <message>
   <source>Zoom in</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>Vergrößern</translation>
  </message>
  <message>
   <source>Magnify (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>Vergrößern (das Mausrad tut es am Mauszeiger)</translation>
  </message>
  <message>
   <source>Zoom out</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>Verkleinern</translation>
  </message>
  <message>
   <source>Reduce (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>Verkleinern (das Mausrad tut es am Mauszeiger)</translation>
  </message>
  <message>
   <source>Pan</source>
   <extracomment>[the action pan]</extracomment>
   <translation>Verschieben</translation>
  </message>
  <message>
   <source>The left button moves the picture (or hold Space, or the middle button); Esc ends it</source>
   <extracomment>[the action pan]</extracomment>
   <translation>Die linke Taste bewegt das Bild (oder Leertaste halten, oder mittlere Taste); Esc beendet es</translation>
  </message>
  <message>
   <source>Keep zoom across frames</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>Ausschnitt beibehalten</translation>
  </message>
  <message>
   <source>Stay at this place of the picture when the frame changes</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>Beim Bildwechsel an derselben Stelle bleiben</translation>
  </message>
  <message>
   <source>Hide overlays</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>Überlagerungen ausblenden</translation>
  </message>
  <message>
   <source>Show the bare picture (or hold X)</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>Das bloße Bild zeigen (oder X halten)</translation>
  </message>
  <message>
   <source>Colour by</source>
   <extracomment>[the menus, the setting colour_by]</extracomment>
   <translation>Färben nach</translation>
  </message>
  <message>
   <source>Criterion</source>
   <extracomment>[the action colour_criterion, the setting colour_by]</extracomment>
   <translation>Kriterium</translation>
  </message>
  <message>
   <source>Colours say how the camera is judged</source>
   <extracomment>[the action colour_criterion]</extracomment>
   <translation>Farben sagen, wie die Kamera beurteilt wird</translation>
  </message>
  <message>
   <source>Class</source>
   <extracomment>[the action colour_class, the setting colour_by]</extracomment>
   <translation>Klasse</translation>
  </message>
  <message>
   <source>Every element in its own colour</source>
   <extracomment>[the action colour_class]</extracomment>
   <translation>Jedes Element in seiner eigenen Farbe</translation>
  </message>
  <message>
   <source>Provenance</source>
   <extracomment>[the action colour_origin, the setting colour_by]</extracomment>
   <translation>Herkunft</translation>
  </message>
  <message>
   <source>Points by how they came to be: clicked, snapped, regularised, copied, moved</source>
   <extracomment>[the action colour_origin]</extracomment>
   <translation>Punkte danach, wie sie entstanden: geklickt, eingerastet, begradigt, kopiert, verschoben</translation>
  </message>
  <message>
   <source>Annotator</source>
   <extracomment>[the action colour_annotator, the setting colour_by]</extracomment>
   <translation>Annotator</translation>
  </message>
  <message>
   <source>Points by who put them there</source>
   <extracomment>[the action colour_annotator]</extracomment>
   <translation>Punkte danach, wer sie gesetzt hat</translation>
  </message>
  <message>
   <source>Painted width</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>Linienbreite</translation>
  </message>
  <message>
   <source>Draw how wide the field's lines must appear, along the projection</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>Neben der Projektion zeigen, wie breit die Farbe der Feldlinien erscheinen muss</translation>
  </message>
  <message>
   <source>Evidence of paint</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>Belege im Bild</translation>
  </message>
  <message>
   <source>Beside every segment a strip: solid where the picture shows paint under it, dashed where paint runs beside it, on that side, dotted where there is none</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>Neben jedem Abschnitt ein Streifen: durchgezogen, wo das Bild darunter Farbe zeigt, gestrichelt, wo Farbe daneben verläuft, auf dieser Seite, gepunktet, wo keine ist</translation>
  </message>
  <message>
   <source>Loupe</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>Lupe</translation>
  </message>
  <message>
   <source>Keep the loupe at the cursor (or hold Z; it also comes while a point is dragged)</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>Die Lupe am Mauszeiger behalten (oder Z halten; sie kommt auch beim Ziehen eines Punktes)</translation>
  </message>
  <message>
   <source>Legend in the picture</source>
   <extracomment>[the action legend, the setting legend]</extracomment>
   <translation>Legende im Bild</translation>
  </message>
  <message>
   <source>What the colours, dashes and marks over the picture mean, in its corner; it gives way to the hand</source>
   <extracomment>[the action legend, the setting legend]</extracomment>
   <translation>Was die Farben, Striche und Zeichen über dem Bild bedeuten, in seiner Ecke; sie weicht der Hand</translation>
  </message>
  <message>
   <source>Turn the field map to the camera</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>Feldkarte zur Kamera drehen</translation>
  </message>
  <message>
   <source>The field map has the side below that the camera stands on, and what the camera does not see is faint</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>Auf der Feldkarte liegt die Seite unten, auf der die Kamera steht, und was sie nicht sieht, ist blass</translation>
  </message>
  <message>
   <source>Picture on the field map</source>
   <extracomment>[the action top_view, the setting top_view]</extracomment>
   <translation>Bild auf der Feldkarte</translation>
  </message>
  <message>
   <source>Show the picture on the field map, as seen from above: lines that bend or miss the map's show where a camera is wrong</source>
   <extracomment>[the action top_view, the setting top_view]</extracomment>
   <translation>Das Bild von oben gesehen auf der Feldkarte zeigen: Linien, die sich biegen oder die der Karte verfehlen, zeigen, wo eine Kamera falsch ist</translation>
  </message>
  <message>
   <source>Strip of frames</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>Bilderstreifen</translation>
  </message>
  <message>
   <source>Below the picture: thumbnails of the frames, or the timeline of a video</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>Unter dem Bild: Vorschaubilder oder die Zeitleiste eines Videos</translation>
  </message>
  <message>
   <source>List of frames</source>
   <extracomment>[the action frames_list]</extracomment>
   <translation>Liste der Bilder</translation>
  </message>
  <message>
   <source>Show the frames with their names and a filter at the left, instead of the strip; once more closes the list</source>
   <extracomment>[the action frames_list]</extracomment>
   <translation>Links die Bilder mit Namen und Filter zeigen, statt des Streifens; noch einmal schließt die Liste</translation>
  </message>
  <message>
   <source>Errors and JaC of the frame or the set, of all shown sources</source>
   <extracomment>[the action plots]</extracomment>
   <translation>Fehler und JaC des Bildes oder des Satzes, für alle gezeigten Quellen</translation>
  </message>
  <message>
   <source>Panels to annotate</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>Bereiche zum Annotieren</translation>
  </message>
  <message>
   <source>Elements, what the check found, landmarks</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>Elemente, Befunde der Prüfung, Landmarken</translation>
  </message>
  <message>
   <source>Panels to judge</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>Bereiche zum Beurteilen</translation>
  </message>
  <message>
   <source>Scores, camera sources, the fit, plots</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>Bewertungen, Kameraquellen, Anpassung, Diagramme</translation>
  </message>
  <message>
   <source>Panels to review</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>Bereiche zum Prüfen</translation>
  </message>
  <message>
   <source>Status, comments and time, a second annotator</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>Status, Kommentare und Zeit, ein zweiter Annotator</translation>
  </message>
  <message>
   <source>Hide all panels</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>Alle Bereiche ausblenden</translation>
  </message>
  <message>
   <source>Give the picture all the room</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>Dem Bild allen Platz geben</translation>
  </message>
  <message>
   <source>Keyboard to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>Tastatur zu den Bereichen</translation>
  </message>
  <message>
   <source>Tab goes through ghosts in the picture; this takes the keyboard on to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>Im Bild geht Tab durch die Geister; dies führt die Tastatur weiter zu den Bereichen</translation>
  </message>
  <message>
   <source>Keyboard to the next part</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>Tastatur zum nächsten Teil</translation>
  </message>
  <message>
   <source>Picture, panels, tool bar: the keyboard goes round them</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>Bild, Bereiche, Leisten: die Tastatur geht reihum</translation>
  </message>
  <message>
   <source>Keyboard to the part before</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>Tastatur zum vorigen Teil</translation>
  </message>
  <message>
   <source>The same way round backwards</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>Reihum in der anderen Richtung</translation>
  </message>
  <message>
   <source>Reset the layout</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>Anordnung zurücksetzen</translation>
  </message>
  <message>
   <source>Put the panels back where they were at first</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>Die Bereiche wieder an ihren ersten Platz legen</translation>
  </message>
  <message>
   <source>Load cameras…</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>Kameras laden…</translation>
  </message>
  <message>
   <source>Judge a folder of cameras or homographies against the annotations</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>Einen Ordner mit Kameras oder Homographien an den Annotationen messen</translation>
  </message>
  <message>
   <source>Load camera file…</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>Kameradatei laden…</translation>
  </message>
  <message>
   <source>Judge a single camera file, or a zip of them</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>Eine einzelne Kameradatei oder ein Zip davon beurteilen</translation>
  </message>
  <message>
   <source>Next camera source</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>Nächste Kameraquelle</translation>
  </message>
  <message>
   <source>Judge with the next of the loaded sources</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>Mit der nächsten geladenen Quelle beurteilen</translation>
  </message>
  <message>
   <source>Previous camera source</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>Vorige Kameraquelle</translation>
  </message>
  <message>
   <source>Judge with the one before</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>Mit der vorigen beurteilen</translation>
  </message>
  <message>
   <source>Swap with the compared source</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>Mit der verglichenen Quelle tauschen</translation>
  </message>
  <message>
   <source>Judge with the source compared, and compare with this one (or tap the comma; hold it to look only)</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>Mit der verglichenen Quelle beurteilen und mit dieser vergleichen (oder Komma tippen; halten, um nur zu schauen)</translation>
  </message>
  <message>
   <source>Draw other sources</source>
   <extracomment>[the action others]</extracomment>
   <translation>Andere Quellen zeichnen</translation>
  </message>
  <message>
   <source>Draw the sources ticked in the Cameras panel as wireframes, with the active one</source>
   <extracomment>[the action others]</extracomment>
   <translation>Die im Bereich Kameras angehakten Quellen als Drahtgitter neben der aktiven zeichnen</translation>
  </message>
  <message>
   <source>Split view</source>
   <extracomment>[the action split]</extracomment>
   <translation>Geteilte Ansicht</translation>
  </message>
  <message>
   <source>Draw the active source left of a divider, the compared one right of it</source>
   <extracomment>[the action split]</extracomment>
   <translation>Links einer Trennlinie die aktive Quelle zeichnen, rechts die verglichene</translation>
  </message>
  <message>
   <source>How many metres apart the active and the compared source see each pixel on the ground</source>
   <extracomment>[the action disagreement]</extracomment>
   <translation>Wie viele Meter die aktive und die verglichene Quelle jedes Pixel am Boden auseinander sehen</translation>
  </message>
  <message>
   <source>Uncertainty map</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>Karte der Unsicherheit</translation>
  </message>
  <message>
   <source>Where on the field the fitted camera is good to 0.1, 0.5 and 1 m</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>Wo auf dem Feld die angepasste Kamera auf 0,1, 0,5 und 1 m genau ist</translation>
  </message>
  <message>
   <source>Live fit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>Laufende Anpassung</translation>
  </message>
  <message>
   <source>Fit a camera to the clicks of the frame after every edit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>Nach jeder Änderung eine Kamera an die Klicks des Bildes anpassen</translation>
  </message>
  <message>
   <source>Save fit as the frame's camera</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>Anpassung als Kamera des Bildes speichern</translation>
  </message>
  <message>
   <source>Write the camera fitted to the clicks into the folder cameras/fitted of the dataset</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>Die an die Klicks angepasste Kamera in den Ordner cameras/fitted des Datensatzes schreiben</translation>
  </message>
  <message>
   <source>Field dimensions…</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>Feldmaße…</translation>
  </message>
  <message>
   <source>Length and width of this stadium's field, entered or found from all frames; and where on its lines the clicks lie</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>Länge und Breite des Feldes in diesem Stadion, eingegeben oder aus allen Bildern ermittelt; und wo auf seinen Linien die Klicks liegen</translation>
  </message>
  <message>
   <source>Threshold up 0.5 px</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>Schwelle 0.5 px höher</translation>
  </message>
  <message>
   <source>Allow larger distances</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>Größere Abstände zulassen</translation>
  </message>
  <message>
   <source>Threshold down 0.5 px</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>Schwelle 0.5 px tiefer</translation>
  </message>
  <message>
   <source>Allow smaller distances only</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>Nur kleinere Abstände zulassen</translation>
  </message>
  <message>
   <source>soccernet</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>soccernet</translation>
  </message>
  <message>
   <source>The official SoccerNet evaluation, quirks included</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>Die offizielle SoccerNet-Auswertung, mit ihren Eigenheiten</translation>
  </message>
  <message>
   <source>procc</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>procc</translation>
  </message>
  <message>
   <source>The paper's definition, without the official code's artefacts</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>Die Definition der Veröffentlichung, ohne die Artefakte des offiziellen Codes</translation>
  </message>
  <message>
   <source>Elements off the ground</source>
   <extracomment>[the menus, the setting off_plane]</extracomment>
   <translation>Elemente über dem Boden</translation>
  </message>
  <message>
   <source>Count as missed</source>
   <extracomment>[the action off_plane_missed, the setting off_plane]</extracomment>
   <translation>Als verfehlt zählen</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project count against it</source>
   <extracomment>[the action off_plane_missed]</extracomment>
   <translation>Tore, Körbe und Netze, die eine Homographie nicht projizieren kann, zählen gegen sie</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project are not counted</source>
   <extracomment>[the action off_plane_left_out]</extracomment>
   <translation>Tore, Körbe und Netze, die eine Homographie nicht projizieren kann, werden nicht gezählt</translation>
  </message>
  <message>
   <source>Camera wrong</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>Kamera falsch</translation>
  </message>
  <message>
   <source>The active camera is wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>Die aktive Kamera ist in diesem Bild falsch; noch einmal nimmt das Urteil zurück</translation>
  </message>
  <message>
   <source>Labels wrong</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>Annotation falsch</translation>
  </message>
  <message>
   <source>The clicks are wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>Die Klicks sind in diesem Bild falsch; noch einmal nimmt das Urteil zurück</translation>
  </message>
  <message>
   <source>OK</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>OK</translation>
  </message>
  <message>
   <source>Camera and clicks are right in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>Kamera und Klicks sind in diesem Bild richtig; noch einmal nimmt das Urteil zurück</translation>
  </message>
  <message>
   <source>Note on the verdict…</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>Notiz zum Urteil…</translation>
  </message>
  <message>
   <source>Say in a few words what is wrong; it is exported with the verdict</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>In wenigen Worten sagen, was falsch ist; es wird mit dem Urteil exportiert</translation>
  </message>
  <message>
   <source>Stop scoring the set</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>Bewertung des Satzes anhalten</translation>
  </message>
  <message>
   <source>Stop computing the JaC of the frames not opened yet, and comparing sources</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>Den JaC noch nicht geöffneter Bilder und den Vergleich der Quellen nicht weiter berechnen</translation>
  </message>
  <message>
   <source>Find anything…</source>
   <extracomment>[the action palette]</extracomment>
   <translation>Alles finden…</translation>
  </message>
  <message>
   <source>The command palette: every action, element, frame, camera source and recent folder, by a few letters of its name</source>
   <extracomment>[the action palette]</extracomment>
   <translation>Die Befehlspalette: jede Aktion, jedes Element, Bild, jede Kameraquelle und jeder letzte Ordner nach ein paar Buchstaben des Namens</translation>
  </message>
  <message>
   <source>Draw, accept, check, judge and export, step by step, on a copy of the sample</source>
   <extracomment>[the action tour]</extracomment>
   <translation>Zeichnen, annehmen, prüfen, beurteilen, exportieren: Schritt für Schritt an einer Beispielkopie</translation>
  </message>
  <message>
   <source>Show all actions and their keys on one sheet</source>
   <extracomment>[the action keys]</extracomment>
   <translation>Alle Aktionen und ihre Tasten auf einem Blatt zeigen</translation>
  </message>
  <message>
   <source>Give actions and elements other keys, or take those of another program</source>
   <extracomment>[the action keymap]</extracomment>
   <translation>Aktionen und Elementen andere Tasten geben, oder die eines anderen Programms übernehmen</translation>
  </message>
  <message>
   <source>The guide that comes with the program; it needs no network</source>
   <extracomment>[the action guide]</extracomment>
   <translation>Das mitgelieferte Handbuch; es braucht kein Netz</translation>
  </message>
  <message>
   <source>Copy details of the last error</source>
   <extracomment>[the action copy_error]</extracomment>
   <translation>Einzelheiten des letzten Fehlers kopieren</translation>
  </message>
  <message>
   <source>What an unexpected error left in the log, for a report to the maintainers</source>
   <extracomment>[the action copy_error]</extracomment>
   <translation>Was ein unerwarteter Fehler im Protokoll hinterließ, für eine Meldung an die Entwickler</translation>
  </message>
  <message>
   <source>Version</source>
   <extracomment>[the action about]</extracomment>
   <translation>Version</translation>
  </message>
  <message>
   <source>Appearance</source>
   <extracomment>[the setting colour_by, the setting font_percent, the setting language]</extracomment>
   <translation>Aussehen</translation>
  </message>
  <message>
   <source>Theme</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Farbschema</translation>
  </message>
  <message>
   <source>Light, dark or system</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Hell, dunkel oder wie das System</translation>
  </message>
  <message>
   <source>System</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>System</translation>
  </message>
  <message>
   <source>Light</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Hell</translation>
  </message>
  <message>
   <source>Dark</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Dunkel</translation>
  </message>
  <message>
   <source>Text size</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>Textgröße</translation>
  </message>
  <message>
   <source>Text size, % of system (after restart)</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>Textgröße, % der Systemgröße (nach Neustart)</translation>
  </message>
  <message>
   <source>Language</source>
   <extracomment>[the setting language]</extracomment>
   <translation>Sprache</translation>
  </message>
  <message>
   <source>Language of the window (after restart); files stay as they are</source>
   <extracomment>[the setting language]</extracomment>
   <translation>Sprache des Fensters (nach Neustart); Dateien bleiben, wie sie sind</translation>
  </message>
  <message>
   <source>What the colours over the picture say</source>
   <extracomment>[the setting colour_by]</extracomment>
   <translation>Was die Farben über dem Bild sagen</translation>
  </message>
  <message>
   <source>Author name</source>
   <extracomment>[the setting author]</extracomment>
   <translation>Name des Autors</translation>
  </message>
  <message>
   <source>Author name (empty = login name)</source>
   <extracomment>[the setting author]</extracomment>
   <translation>Name des Autors (leer = Anmeldename)</translation>
  </message>
  <message>
   <source>Judging</source>
   <extracomment>[the setting blind, the setting off_plane, the setting protocol]</extracomment>
   <translation>Beurteilen</translation>
  </message>
  <message>
   <source>Threshold</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>Schwelle</translation>
  </message>
  <message>
   <source>How far an annotated point may be from its element, px of the evaluation size</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>Wie weit ein annotierter Punkt von seinem Element entfernt sein darf, in px der Auswertungsgröße</translation>
  </message>
  <message>
   <source>How cameras are judged: as the official evaluation does, quirks included, or by the paper's definition</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>Wie Kameras beurteilt werden: wie in der offiziellen Auswertung samt Eigenheiten, oder nach der Definition der Veröffentlichung</translation>
  </message>
  <message>
   <source>procc (the paper's)</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>procc (Veröffentlichung)</translation>
  </message>
  <message>
   <source>How elements count that a homography cannot project: goals, baskets, nets</source>
   <extracomment>[the setting off_plane]</extracomment>
   <translation>Wie Elemente zählen, die eine Homographie nicht projizieren kann: Tore, Körbe, Netze</translation>
  </message>
  <message>
   <source>Model of the live fit</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>Modell der laufenden Anpassung</translation>
  </message>
  <message>
   <source>The camera that is fitted to the clicks; auto: the simplest that they support</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>Die Kamera, die an die Klicks angepasst wird; auto: die einfachste, die sie hergeben</translation>
  </message>
  <message>
   <source>Judge the fit</source>
   <extracomment>[the setting judge_fit]</extracomment>
   <translation>Anpassung beurteilen</translation>
  </message>
  <message>
   <source>Whether the fit is judged where nothing else is</source>
   <extracomment>[the setting judge_fit]</extracomment>
   <translation>Ob die Anpassung beurteilt wird, wo es nichts anderes gibt</translation>
  </message>
  <message>
   <source>Line seen to accept all</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>Sichtbarer Teil, um alle anzunehmen</translation>
  </message>
  <message>
   <source>How much of a ghost's line must be seen to accept it with all others</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>Wie viel der Linie eines Geistes zu sehen sein muss, um ihn mit allen anderen anzunehmen</translation>
  </message>
  <message>
   <source>American football (NFL)</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>American Football (NFL)</translation>
  </message>
  <message>
   <source>Near sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Nahe Seitenlinie</translation>
  </message>
  <message>
   <source>Far sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ferne Seitenlinie</translation>
  </message>
  <message>
   <source>Near hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Nahe Hash-Marken</translation>
  </message>
  <message>
   <source>Far hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ferne Hash-Marken</translation>
  </message>
  <message>
   <source>Left end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>Linke Endlinie</translation>
  </message>
  <message>
   <source>Left goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Linke Torlinie</translation>
  </message>
  <message>
   <source>Left 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 5-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 10-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 15-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 20-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 25-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 30-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 35-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 40-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 45-Yard-Linie</translation>
  </message>
  <message>
   <source>50-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>50-Yard-Linie</translation>
  </message>
  <message>
   <source>Right end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>Rechte Endlinie</translation>
  </message>
  <message>
   <source>Right goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Rechte Torlinie</translation>
  </message>
  <message>
   <source>Right 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 5-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 10-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 15-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 20-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 25-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 30-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 35-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 40-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 45-Yard-Linie</translation>
  </message>
  <message>
   <source>Left crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Linke Querlatte</translation>
  </message>
  <message>
   <source>Left goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linkes Tor, linke Stange</translation>
  </message>
  <message>
   <source>Left goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linkes Tor, rechte Stange</translation>
  </message>
  <message>
   <source>Right crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Rechte Querlatte</translation>
  </message>
  <message>
   <source>Right goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechtes Tor, linke Stange</translation>
  </message>
  <message>
   <source>Right goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechtes Tor, rechte Stange</translation>
  </message>
  <message>
   <source>Left try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke Try-Marke</translation>
  </message>
  <message>
   <source>Right try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte Try-Marke</translation>
  </message>
  <message>
   <source>Length with both end zones</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Länge mit beiden Endzonen</translation>
  </message>
  <message>
   <source>Width</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Breite</translation>
  </message>
  <message>
   <source>Depth of an end zone</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Tiefe einer Endzone</translation>
  </message>
  <message>
   <source>Yard</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Yard</translation>
  </message>
  <message>
   <source>Yard line to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Yard-Linie zur Seitenlinie</translation>
  </message>
  <message>
   <source>Hash marks to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Hash-Marken zur Seitenlinie</translation>
  </message>
  <message>
   <source>Try mark to goal line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Try-Marke zur Torlinie</translation>
  </message>
  <message>
   <source>Try mark length</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Länge der Try-Marke</translation>
  </message>
  <message>
   <source>Goal width</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Torbreite</translation>
  </message>
  <message>
   <source>Crossbar height</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Höhe der Querlatte</translation>
  </message>
  <message>
   <source>Uprights above the crossbar</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Stangen über der Querlatte</translation>
  </message>
  <message>
   <source>Line width</source>
   <extracomment>[the field american_football, the field athletics, the field basketball_fiba]</extracomment>
   <translation>Linienbreite</translation>
  </message>
  <message>
   <source>Goal line width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Breite der Torlinie</translation>
  </message>
  <message>
   <source>Border width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Breite des Randes</translation>
  </message>
  <message>
   <source>Left half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke Hälfte</translation>
  </message>
  <message>
   <source>Right half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte Hälfte</translation>
  </message>
  <message>
   <source>Left goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Linkes Tor</translation>
  </message>
  <message>
   <source>Right goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Rechtes Tor</translation>
  </message>
  <message>
   <source>Athletics (400 m track)</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Leichtathletik (400-m-Bahn)</translation>
  </message>
  <message>
   <source>Kerb</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bordkante</translation>
  </message>
  <message>
   <source>Lane line 1 | 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnlinie 1 | 2</translation>
  </message>
  <message>
   <source>Lane line 2 | 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnlinie 2 | 3</translation>
  </message>
  <message>
   <source>Lane line 3 | 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnlinie 3 | 4</translation>
  </message>
  <message>
   <source>Lane line 4 | 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnlinie 4 | 5</translation>
  </message>
  <message>
   <source>Lane line 5 | 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnlinie 5 | 6</translation>
  </message>
  <message>
   <source>Lane line 6 | 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnlinie 6 | 7</translation>
  </message>
  <message>
   <source>Lane line 7 | 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnlinie 7 | 8</translation>
  </message>
  <message>
   <source>Lane 8, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahn 8, äußerer Rand</translation>
  </message>
  <message>
   <source>Lane 9, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahn 9, äußerer Rand</translation>
  </message>
  <message>
   <source>Finish line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ziellinie</translation>
  </message>
  <message>
   <source>100 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 100 m</translation>
  </message>
  <message>
   <source>110 m hurdles start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 110 m Hürden</translation>
  </message>
  <message>
   <source>3000 m and 5000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 3000 m und 5000 m</translation>
  </message>
  <message>
   <source>10,000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 10 000 m</translation>
  </message>
  <message>
   <source>Break line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Linie zum Einbiegen</translation>
  </message>
  <message>
   <source>200 m start, lane 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 1</translation>
  </message>
  <message>
   <source>200 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 2</translation>
  </message>
  <message>
   <source>200 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 3</translation>
  </message>
  <message>
   <source>200 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 4</translation>
  </message>
  <message>
   <source>200 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 5</translation>
  </message>
  <message>
   <source>200 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 6</translation>
  </message>
  <message>
   <source>200 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 7</translation>
  </message>
  <message>
   <source>200 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 8</translation>
  </message>
  <message>
   <source>200 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 9</translation>
  </message>
  <message>
   <source>400 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 2</translation>
  </message>
  <message>
   <source>400 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 3</translation>
  </message>
  <message>
   <source>400 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 4</translation>
  </message>
  <message>
   <source>400 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 5</translation>
  </message>
  <message>
   <source>400 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 6</translation>
  </message>
  <message>
   <source>400 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 7</translation>
  </message>
  <message>
   <source>400 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 8</translation>
  </message>
  <message>
   <source>400 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 9</translation>
  </message>
  <message>
   <source>800 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 2</translation>
  </message>
  <message>
   <source>800 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 3</translation>
  </message>
  <message>
   <source>800 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 4</translation>
  </message>
  <message>
   <source>800 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 5</translation>
  </message>
  <message>
   <source>800 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 6</translation>
  </message>
  <message>
   <source>800 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 7</translation>
  </message>
  <message>
   <source>800 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 8</translation>
  </message>
  <message>
   <source>800 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 9</translation>
  </message>
  <message>
   <source>Sprint track kerb line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, innere Linie</translation>
  </message>
  <message>
   <source>Sprint track line 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 1</translation>
  </message>
  <message>
   <source>Sprint track line 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 2</translation>
  </message>
  <message>
   <source>Sprint track line 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 3</translation>
  </message>
  <message>
   <source>Sprint track line 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 4</translation>
  </message>
  <message>
   <source>Sprint track line 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 5</translation>
  </message>
  <message>
   <source>Sprint track line 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 6</translation>
  </message>
  <message>
   <source>Sprint track line 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 7</translation>
  </message>
  <message>
   <source>Sprint track line 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 8</translation>
  </message>
  <message>
   <source>Length over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Länge über acht Bahnen</translation>
  </message>
  <message>
   <source>Width over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Breite über acht Bahnen</translation>
  </message>
  <message>
   <source>Lane width</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnbreite</translation>
  </message>
  <message>
   <source>Lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnen</translation>
  </message>
  <message>
   <source>Finish and starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ziel und Starts</translation>
  </message>
  <message>
   <source>200 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Starts über 200 m</translation>
  </message>
  <message>
   <source>400 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Starts über 400 m</translation>
  </message>
  <message>
   <source>800 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Starts über 800 m</translation>
  </message>
  <message>
   <source>Sprint track</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn</translation>
  </message>
  <message>
   <source>Basketball (FIBA)</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Basketball (FIBA)</translation>
  </message>
  <message>
   <source>Right endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechte Endlinie</translation>
  </message>
  <message>
   <source>Left endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linke Endlinie</translation>
  </message>
  <message>
   <source>Centre line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Mittellinie</translation>
  </message>
  <message>
   <source>Centre circle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>Mittelkreis</translation>
  </message>
  <message>
   <source>Left key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linke Zone, ferne Seite</translation>
  </message>
  <message>
   <source>Left free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Linke Freiwurflinie</translation>
  </message>
  <message>
   <source>Left key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linke Zone, nahe Seite</translation>
  </message>
  <message>
   <source>Left free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Linker Freiwurfhalbkreis</translation>
  </message>
  <message>
   <source>Right key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechte Zone, ferne Seite</translation>
  </message>
  <message>
   <source>Right free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Rechte Freiwurflinie</translation>
  </message>
  <message>
   <source>Right key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechte Zone, nahe Seite</translation>
  </message>
  <message>
   <source>Right free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Rechter Freiwurfhalbkreis</translation>
  </message>
  <message>
   <source>Left three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linker Dreipunktebogen</translation>
  </message>
  <message>
   <source>Left three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linke Dreipunktelinie, ferne Gerade</translation>
  </message>
  <message>
   <source>Left three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linke Dreipunktelinie, nahe Gerade</translation>
  </message>
  <message>
   <source>Right three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechter Dreipunktebogen</translation>
  </message>
  <message>
   <source>Right three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechte Dreipunktelinie, ferne Gerade</translation>
  </message>
  <message>
   <source>Right three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechte Dreipunktelinie, nahe Gerade</translation>
  </message>
  <message>
   <source>Left backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linkes Spielbrett</translation>
  </message>
  <message>
   <source>Left rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linker Ring</translation>
  </message>
  <message>
   <source>Left no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Linker No-Charge-Halbkreis</translation>
  </message>
  <message>
   <source>Right backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechtes Spielbrett</translation>
  </message>
  <message>
   <source>Right rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechter Ring</translation>
  </message>
  <message>
   <source>Right no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Rechter No-Charge-Halbkreis</translation>
  </message>
  <message>
   <source>Left backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechteck des linken Spielbretts</translation>
  </message>
  <message>
   <source>Left rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Mitte des linken Rings</translation>
  </message>
  <message>
   <source>Right backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechteck des rechten Spielbretts</translation>
  </message>
  <message>
   <source>Right rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Mitte des rechten Rings</translation>
  </message>
  <message>
   <source>Length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>Länge</translation>
  </message>
  <message>
   <source>Centre line beyond the sidelines</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Mittellinie über die Seitenlinien hinaus</translation>
  </message>
  <message>
   <source>Circle radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field soccer]</extracomment>
   <translation>Radius des Kreises</translation>
  </message>
  <message>
   <source>Key length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Länge der Zone</translation>
  </message>
  <message>
   <source>Key width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Breite der Zone</translation>
  </message>
  <message>
   <source>Three-point radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Radius der Dreipunktelinie</translation>
  </message>
  <message>
   <source>Three-point line to sideline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Dreipunktelinie zur Seitenlinie</translation>
  </message>
  <message>
   <source>No-charge radius</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Radius des No-Charge-Halbkreises</translation>
  </message>
  <message>
   <source>Backboard to endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Spielbrett zur Endlinie</translation>
  </message>
  <message>
   <source>Backboard width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Breite des Spielbretts</translation>
  </message>
  <message>
   <source>Backboard height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Höhe des Spielbretts</translation>
  </message>
  <message>
   <source>Backboard's lower edge</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Unterkante des Spielbretts</translation>
  </message>
  <message>
   <source>Backboard rectangle width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Breite des Rechtecks</translation>
  </message>
  <message>
   <source>Backboard rectangle height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Höhe des Rechtecks</translation>
  </message>
  <message>
   <source>Rim height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Höhe des Rings</translation>
  </message>
  <message>
   <source>Rim radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Radius des Rings</translation>
  </message>
  <message>
   <source>Rim to backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ring zum Spielbrett</translation>
  </message>
  <message>
   <source>Court</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Spielfeld</translation>
  </message>
  <message>
   <source>Left key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linke Zone</translation>
  </message>
  <message>
   <source>Right key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechte Zone</translation>
  </message>
  <message>
   <source>Left three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linke Dreipunktelinie</translation>
  </message>
  <message>
   <source>Right three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechte Dreipunktelinie</translation>
  </message>
  <message>
   <source>Left basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linker Korb</translation>
  </message>
  <message>
   <source>Right basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechter Korb</translation>
  </message>
  <message>
   <source>Basketball (NBA)</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Basketball (NBA)</translation>
  </message>
  <message>
   <source>Left free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Linker Freiwurfkreis</translation>
  </message>
  <message>
   <source>Right free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Rechter Freiwurfkreis</translation>
  </message>
  <message>
   <source>Left restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Linker Bogen der Schutzzone</translation>
  </message>
  <message>
   <source>Right restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Rechter Bogen der Schutzzone</translation>
  </message>
  <message>
   <source>Inner centre circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Innerer Mittelkreis</translation>
  </message>
  <message>
   <source>Left far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Linke ferne Hash-Marke</translation>
  </message>
  <message>
   <source>Right far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Rechte ferne Hash-Marke</translation>
  </message>
  <message>
   <source>Left near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Linke nahe Hash-Marke</translation>
  </message>
  <message>
   <source>Right near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Rechte nahe Hash-Marke</translation>
  </message>
  <message>
   <source>Inner circle radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Radius des inneren Kreises</translation>
  </message>
  <message>
   <source>Restricted area radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Radius der Schutzzone</translation>
  </message>
  <message>
   <source>Hash mark to endline</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Hash-Marke zur Endlinie</translation>
  </message>
  <message>
   <source>Hash mark length</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Länge der Hash-Marke</translation>
  </message>
  <message>
   <source>Futsal</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Futsal</translation>
  </message>
  <message>
   <source>Near touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Nahe Seitenlinie</translation>
  </message>
  <message>
   <source>Far touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Ferne Seitenlinie</translation>
  </message>
  <message>
   <source>Halfway line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Mittellinie</translation>
  </message>
  <message>
   <source>Left penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Linke Strafraumlinie</translation>
  </message>
  <message>
   <source>Right penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Rechte Strafraumlinie</translation>
  </message>
  <message>
   <source>Left goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Linkes Tor, ferner Pfosten</translation>
  </message>
  <message>
   <source>Left goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Linkes Tor, naher Pfosten</translation>
  </message>
  <message>
   <source>Right goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Rechtes Tor, ferner Pfosten</translation>
  </message>
  <message>
   <source>Right goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Rechtes Tor, naher Pfosten</translation>
  </message>
  <message>
   <source>Centre mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Anstoßpunkt</translation>
  </message>
  <message>
   <source>Left penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Linker Strafstoßpunkt</translation>
  </message>
  <message>
   <source>Left second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Linker zweiter Strafstoßpunkt</translation>
  </message>
  <message>
   <source>Right penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Rechter Strafstoßpunkt</translation>
  </message>
  <message>
   <source>Right second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Rechter zweiter Strafstoßpunkt</translation>
  </message>
  <message>
   <source>Left far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Linker ferner Viertelkreis</translation>
  </message>
  <message>
   <source>Left near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Linker naher Viertelkreis</translation>
  </message>
  <message>
   <source>Right far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Rechter ferner Viertelkreis</translation>
  </message>
  <message>
   <source>Right near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Rechter naher Viertelkreis</translation>
  </message>
  <message>
   <source>Far substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Ferne Wechselzone, links außen</translation>
  </message>
  <message>
   <source>Far substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Ferne Wechselzone, links innen</translation>
  </message>
  <message>
   <source>Far substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Ferne Wechselzone, rechts innen</translation>
  </message>
  <message>
   <source>Far substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Ferne Wechselzone, rechts außen</translation>
  </message>
  <message>
   <source>Near substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Nahe Wechselzone, links außen</translation>
  </message>
  <message>
   <source>Near substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Nahe Wechselzone, links innen</translation>
  </message>
  <message>
   <source>Near substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Nahe Wechselzone, rechts innen</translation>
  </message>
  <message>
   <source>Near substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Nahe Wechselzone, rechts außen</translation>
  </message>
  <message>
   <source>Goalpost width</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Breite der Torpfosten</translation>
  </message>
  <message>
   <source>Penalty area radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Radius des Strafraums</translation>
  </message>
  <message>
   <source>Penalty mark to goal line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Strafstoßpunkt zur Torlinie</translation>
  </message>
  <message>
   <source>Second penalty mark to goal line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zweiter Strafstoßpunkt zur Torlinie</translation>
  </message>
  <message>
   <source>Centre circle radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Radius des Mittelkreises</translation>
  </message>
  <message>
   <source>Corner arc radius</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Radius der Viertelkreise</translation>
  </message>
  <message>
   <source>Goal height</source>
   <extracomment>[the field futsal, the field handball, the field ice_hockey_iihf]</extracomment>
   <translation>Torhöhe</translation>
  </message>
  <message>
   <source>Pitch</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Spielfeld</translation>
  </message>
  <message>
   <source>Left penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Linker Strafraum</translation>
  </message>
  <message>
   <source>Right penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Rechter Strafraum</translation>
  </message>
  <message>
   <source>Marks</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Punkte</translation>
  </message>
  <message>
   <source>Corners</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Ecken</translation>
  </message>
  <message>
   <source>Substitution zones</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Wechselzonen</translation>
  </message>
  <message>
   <source>Handball</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Handball</translation>
  </message>
  <message>
   <source>Near side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>Nahe Seitenlinie</translation>
  </message>
  <message>
   <source>Far side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>Ferne Seitenlinie</translation>
  </message>
  <message>
   <source>Throw-off area</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Anwurfzone</translation>
  </message>
  <message>
   <source>Left goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Linke Torraumlinie</translation>
  </message>
  <message>
   <source>Left 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Linke 7-Meter-Linie</translation>
  </message>
  <message>
   <source>Left 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Linke 4-Meter-Linie</translation>
  </message>
  <message>
   <source>Right goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Rechte Torraumlinie</translation>
  </message>
  <message>
   <source>Right 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Rechte 7-Meter-Linie</translation>
  </message>
  <message>
   <source>Right 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Rechte 4-Meter-Linie</translation>
  </message>
  <message>
   <source>Far substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ferne Wechsellinie, links</translation>
  </message>
  <message>
   <source>Far substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ferne Wechsellinie, rechts</translation>
  </message>
  <message>
   <source>Near substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Nahe Wechsellinie, links</translation>
  </message>
  <message>
   <source>Near substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Nahe Wechsellinie, rechts</translation>
  </message>
  <message>
   <source>Goal area radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Radius des Torraums</translation>
  </message>
  <message>
   <source>Free-throw line radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Radius der Freiwurflinie</translation>
  </message>
  <message>
   <source>Left goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>Linker Torraum</translation>
  </message>
  <message>
   <source>Right goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>Rechter Torraum</translation>
  </message>
  <message>
   <source>Substitution lines</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Wechsellinien</translation>
  </message>
  <message>
   <source>Ice hockey (IIHF)</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>Eishockey (IIHF)</translation>
  </message>
  <message>
   <source>Near side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Nahe Seitenbande</translation>
  </message>
  <message>
   <source>Far side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferne Seitenbande</translation>
  </message>
  <message>
   <source>Left end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Linke Endbande</translation>
  </message>
  <message>
   <source>Right end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rechte Endbande</translation>
  </message>
  <message>
   <source>Near left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Nahe linke Ecke</translation>
  </message>
  <message>
   <source>Far left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferne linke Ecke</translation>
  </message>
  <message>
   <source>Near right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Nahe rechte Ecke</translation>
  </message>
  <message>
   <source>Far right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferne rechte Ecke</translation>
  </message>
  <message>
   <source>Left blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Linke blaue Linie</translation>
  </message>
  <message>
   <source>Right blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rechte blaue Linie</translation>
  </message>
  <message>
   <source>Near left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Naher linker Kreis</translation>
  </message>
  <message>
   <source>Far left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferner linker Kreis</translation>
  </message>
  <message>
   <source>Near right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Naher rechter Kreis</translation>
  </message>
  <message>
   <source>Far right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferner rechter Kreis</translation>
  </message>
  <message>
   <source>Left goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Linker Torraum</translation>
  </message>
  <message>
   <source>Left goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Linkes Tor, linker Pfosten</translation>
  </message>
  <message>
   <source>Left goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Linkes Tor, rechter Pfosten</translation>
  </message>
  <message>
   <source>Right goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rechter Torraum</translation>
  </message>
  <message>
   <source>Right goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Rechtes Tor, linker Pfosten</translation>
  </message>
  <message>
   <source>Right goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Rechtes Tor, rechter Pfosten</translation>
  </message>
  <message>
   <source>Left trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Linkes Trapez, nah</translation>
  </message>
  <message>
   <source>Left trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Linkes Trapez, fern</translation>
  </message>
  <message>
   <source>Right trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rechtes Trapez, nah</translation>
  </message>
  <message>
   <source>Right trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rechtes Trapez, fern</translation>
  </message>
  <message>
   <source>Referee crease near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Schiedsrichterkreis, nah</translation>
  </message>
  <message>
   <source>Referee crease far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Schiedsrichterkreis, fern</translation>
  </message>
  <message>
   <source>Centre spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Mittelpunkt</translation>
  </message>
  <message>
   <source>Near left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Naher linker Endpunkt</translation>
  </message>
  <message>
   <source>Far left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferner linker Endpunkt</translation>
  </message>
  <message>
   <source>Near right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Naher rechter Endpunkt</translation>
  </message>
  <message>
   <source>Far right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferner rechter Endpunkt</translation>
  </message>
  <message>
   <source>Near left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Naher linker Punkt der neutralen Zone</translation>
  </message>
  <message>
   <source>Far left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferner linker Punkt der neutralen Zone</translation>
  </message>
  <message>
   <source>Near right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Naher rechter Punkt der neutralen Zone</translation>
  </message>
  <message>
   <source>Far right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferner rechter Punkt der neutralen Zone</translation>
  </message>
  <message>
   <source>Near boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der nahen Bande</translation>
  </message>
  <message>
   <source>Far boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der fernen Bande</translation>
  </message>
  <message>
   <source>Left boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der linken Bande</translation>
  </message>
  <message>
   <source>Right boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der rechten Bande</translation>
  </message>
  <message>
   <source>Near left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der nahen linken Ecke</translation>
  </message>
  <message>
   <source>Far left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der fernen linken Ecke</translation>
  </message>
  <message>
   <source>Near right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der nahen rechten Ecke</translation>
  </message>
  <message>
   <source>Far right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der fernen rechten Ecke</translation>
  </message>
  <message>
   <source>Corner radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radius der Ecken</translation>
  </message>
  <message>
   <source>Height of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Höhe der Bande</translation>
  </message>
  <message>
   <source>Goal line to end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Torlinie zur Endbande</translation>
  </message>
  <message>
   <source>Blue line to end boards</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>Blaue Linie zur Endbande</translation>
  </message>
  <message>
   <source>Face-off circle radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radius der Bullykreise</translation>
  </message>
  <message>
   <source>End spot to goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Endpunkt zur Torlinie</translation>
  </message>
  <message>
   <source>Neutral spot to blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punkt der neutralen Zone zur blauen Linie</translation>
  </message>
  <message>
   <source>Spot to the long axis</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punkt zur Längsachse</translation>
  </message>
  <message>
   <source>Goal crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radius des Torraums</translation>
  </message>
  <message>
   <source>Goal crease width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Breite des Torraums</translation>
  </message>
  <message>
   <source>Referee crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radius des Schiedsrichterkreises</translation>
  </message>
  <message>
   <source>Trapezoid at the goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapez an der Torlinie</translation>
  </message>
  <message>
   <source>Trapezoid at the end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapez an der Endbande</translation>
  </message>
  <message>
   <source>Blue and centre line width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Breite der blauen und der Mittellinie</translation>
  </message>
  <message>
   <source>Boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bande</translation>
  </message>
  <message>
   <source>Lines</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Linien</translation>
  </message>
  <message>
   <source>Face-off circles</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bullykreise</translation>
  </message>
  <message>
   <source>Face-off spots</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bullypunkte</translation>
  </message>
  <message>
   <source>Top of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der Bande</translation>
  </message>
  <message>
   <source>Ice hockey (NHL)</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>Eishockey (NHL)</translation>
  </message>
  <message>
   <source>Blue line to goal line</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>Blaue Linie zur Torlinie</translation>
  </message>
  <message>
   <source>Soccer</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Fußball</translation>
  </message>
  <message>
   <source>Left penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linker Strafraum, nah</translation>
  </message>
  <message>
   <source>Left penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linker Strafraum, vorn</translation>
  </message>
  <message>
   <source>Left penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linker Strafraum, fern</translation>
  </message>
  <message>
   <source>Right penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechter Strafraum, nah</translation>
  </message>
  <message>
   <source>Right penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechter Strafraum, vorn</translation>
  </message>
  <message>
   <source>Right penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechter Strafraum, fern</translation>
  </message>
  <message>
   <source>Left penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linker Teilkreis</translation>
  </message>
  <message>
   <source>Right penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechter Teilkreis</translation>
  </message>
  <message>
   <source>Left goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linker Torraum, nah</translation>
  </message>
  <message>
   <source>Left goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linker Torraum, vorn</translation>
  </message>
  <message>
   <source>Left goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linker Torraum, fern</translation>
  </message>
  <message>
   <source>Right goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechter Torraum, nah</translation>
  </message>
  <message>
   <source>Right goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechter Torraum, vorn</translation>
  </message>
  <message>
   <source>Right goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechter Torraum, fern</translation>
  </message>
  <message>
   <source>Left far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linke ferne Eckfahne (Fuß)</translation>
  </message>
  <message>
   <source>Left near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linke nahe Eckfahne (Fuß)</translation>
  </message>
  <message>
   <source>Right far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechte ferne Eckfahne (Fuß)</translation>
  </message>
  <message>
   <source>Right near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechte nahe Eckfahne (Fuß)</translation>
  </message>
  <message>
   <source>Penalty area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Tiefe des Strafraums</translation>
  </message>
  <message>
   <source>Penalty area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Breite des Strafraums</translation>
  </message>
  <message>
   <source>Goal area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Tiefe des Torraums</translation>
  </message>
  <message>
   <source>Goal area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Breite des Torraums</translation>
  </message>
  <message>
   <source>Goal unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Tor, unbestimmt</translation>
  </message>
  <message>
   <source>Line unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linie, unbestimmt</translation>
  </message>
  <message>
   <source>Tennis</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Tennis</translation>
  </message>
  <message>
   <source>Left baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Linke Grundlinie</translation>
  </message>
  <message>
   <source>Right baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Rechte Grundlinie</translation>
  </message>
  <message>
   <source>Far doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ferne Doppel-Seitenlinie</translation>
  </message>
  <message>
   <source>Near doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Nahe Doppel-Seitenlinie</translation>
  </message>
  <message>
   <source>Far singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ferne Einzel-Seitenlinie</translation>
  </message>
  <message>
   <source>Near singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Nahe Einzel-Seitenlinie</translation>
  </message>
  <message>
   <source>Left service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Linke Aufschlaglinie</translation>
  </message>
  <message>
   <source>Right service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Rechte Aufschlaglinie</translation>
  </message>
  <message>
   <source>Centre service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Aufschlagmittellinie</translation>
  </message>
  <message>
   <source>Net's top</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Oberkante des Netzes</translation>
  </message>
  <message>
   <source>Far net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ferner Netzpfosten</translation>
  </message>
  <message>
   <source>Near net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Naher Netzpfosten</translation>
  </message>
  <message>
   <source>Net's centre strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Netzhalter in der Mitte</translation>
  </message>
  <message>
   <source>Far singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ferne Einzelstütze</translation>
  </message>
  <message>
   <source>Near singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Nahe Einzelstütze</translation>
  </message>
  <message>
   <source>Left centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Linkes Mittelzeichen</translation>
  </message>
  <message>
   <source>Right centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Rechtes Mittelzeichen</translation>
  </message>
  <message>
   <source>Singles width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Breite des Einzelfelds</translation>
  </message>
  <message>
   <source>Service line to net</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Aufschlaglinie zum Netz</translation>
  </message>
  <message>
   <source>Baseline width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Breite der Grundlinie</translation>
  </message>
  <message>
   <source>Centre line width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Breite der Mittellinie</translation>
  </message>
  <message>
   <source>Centre mark length</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Länge des Mittelzeichens</translation>
  </message>
  <message>
   <source>Net height at the strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Netzhöhe am Netzhalter</translation>
  </message>
  <message>
   <source>Net height at the posts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Netzhöhe an den Pfosten</translation>
  </message>
  <message>
   <source>Net height at the singles sticks</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Netzhöhe an den Einzelstützen</translation>
  </message>
  <message>
   <source>Net post to sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Netzpfosten zur Seitenlinie</translation>
  </message>
  <message>
   <source>Service courts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Aufschlagfelder</translation>
  </message>
  <message>
   <source>Net</source>
   <extracomment>[the field tennis, the field volleyball]</extracomment>
   <translation>Netz</translation>
  </message>
  <message>
   <source>Volleyball</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Volleyball</translation>
  </message>
  <message>
   <source>Left attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Linke Angriffslinie</translation>
  </message>
  <message>
   <source>Right attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Rechte Angriffslinie</translation>
  </message>
  <message>
   <source>Net's top band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Oberes Netzband</translation>
  </message>
  <message>
   <source>Net's bottom band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Unteres Netzband</translation>
  </message>
  <message>
   <source>Far antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Ferne Antenne</translation>
  </message>
  <message>
   <source>Near antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Nahe Antenne</translation>
  </message>
  <message>
   <source>Far post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Ferner Pfosten</translation>
  </message>
  <message>
   <source>Near post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Naher Pfosten</translation>
  </message>
  <message>
   <source>Left far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Linke ferne Verlängerung</translation>
  </message>
  <message>
   <source>Left near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Linke nahe Verlängerung</translation>
  </message>
  <message>
   <source>Right far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Rechte ferne Verlängerung</translation>
  </message>
  <message>
   <source>Right near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Rechte nahe Verlängerung</translation>
  </message>
  <message>
   <source>Left far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Linkes fernes Aufschlagzeichen</translation>
  </message>
  <message>
   <source>Left near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Linkes nahes Aufschlagzeichen</translation>
  </message>
  <message>
   <source>Right far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Rechtes fernes Aufschlagzeichen</translation>
  </message>
  <message>
   <source>Right near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Rechtes nahes Aufschlagzeichen</translation>
  </message>
  <message>
   <source>Attack line to centre line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Angriffslinie zur Mittellinie</translation>
  </message>
  <message>
   <source>Net height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Netzhöhe</translation>
  </message>
  <message>
   <source>Net depth</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Höhe des Netztuchs</translation>
  </message>
  <message>
   <source>Net length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Netzlänge</translation>
  </message>
  <message>
   <source>Antenna above the net</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Antenne über dem Netz</translation>
  </message>
  <message>
   <source>Post to side line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Pfosten zur Seitenlinie</translation>
  </message>
  <message>
   <source>Post height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Höhe der Pfosten</translation>
  </message>
  <message>
   <source>Attack line extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Verlängerung der Angriffslinie</translation>
  </message>
  <message>
   <source>Service mark to end line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Aufschlagzeichen zur Endlinie</translation>
  </message>
  <message>
   <source>Service mark length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Länge des Aufschlagzeichens</translation>
  </message>
  <message>
   <source>Marks outside the court</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Zeichen außerhalb des Feldes</translation>
  </message>
 </context>
</TS>
