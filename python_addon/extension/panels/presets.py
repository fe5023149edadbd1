"""The presets as pictures to choose from: for the active terrain, or a new one."""

import bpy

from .. import preset_files, terrains

COLUMNS = 4


class OROGEN_PT_presets(bpy.types.Panel):
    bl_label = "Presets"
    bl_space_type = "VIEW_3D"
    bl_region_type = "HEADER"
    bl_options = {"INSTANCED"}
    bl_ui_units_x = 26

    def draw(self, context):
        operator = "add_from_preset" if terrains.own(context) is None else "load_preset"
        grid = self.layout.grid_flow(
            row_major=True, columns=COLUMNS, even_columns=True, even_rows=True, align=False
        )
        plain = []
        for file in preset_files.found():
            if icon := preset_files.icon(file):
                card = grid.column(align=True)
                card.template_icon(icon_value=icon, scale=6.0)
                draw_choice(card, operator, file)
            else:
                plain.append(file)
        for file in plain:
            draw_choice(self.layout, operator, file)


def draw_choice(layout, operator, file):
    name = preset_files.name_of(file)
    layout.operator(f"orogen.{operator}", text=name).filepath = str(file)
