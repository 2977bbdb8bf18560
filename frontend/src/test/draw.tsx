import { MantineProvider } from '@mantine/core'
import { render, type RenderResult } from '@testing-library/react'
import type { ReactNode } from 'react'

import { KeysProvider } from '@/app/keys'
import { PaletteProvider } from '@/app/palette'
import { theme } from '@/app/theme'

function Around({ children }: { children: ReactNode }) {
  return (
    <MantineProvider theme={theme} env="test">
      <KeysProvider>
        <PaletteProvider>{children}</PaletteProvider>
      </KeysProvider>
    </MantineProvider>
  )
}

/** Draw a component inside everything that the app puts round it, without a router. */
export const draw = (what: ReactNode): RenderResult => render(what, { wrapper: Around })
