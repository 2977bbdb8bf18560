import { MantineProvider } from '@mantine/core'
import { QueryClientProvider } from '@tanstack/react-query'
import { RouterProvider } from '@tanstack/react-router'

import { queryClient } from '@/api/queryClient'

import { KeysProvider } from './keys'
import { PaletteProvider } from './palette'
import { router } from './router'
import { schemeManager, theme, tokensForMantine } from './theme'

export function App() {
  return (
    <MantineProvider
      theme={theme}
      cssVariablesResolver={tokensForMantine}
      colorSchemeManager={schemeManager}
      defaultColorScheme="auto"
    >
      <QueryClientProvider client={queryClient}>
        <KeysProvider>
          <PaletteProvider>
            <RouterProvider router={router} />
          </PaletteProvider>
        </KeysProvider>
      </QueryClientProvider>
    </MantineProvider>
  )
}
